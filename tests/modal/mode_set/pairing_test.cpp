#include "modal/mode_set/pairing.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/mac.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace tapfit::modal {
namespace {

using Eigen::Index;

double cost_of(const Eigen::MatrixXd& cost, const std::vector<Index>& columns) {
  double sum = 0.0;
  for (std::size_t r = 0; r < columns.size() && r < 4; ++r) {
    sum += cost(static_cast<Index>(r), columns[r]);
  }
  return sum;
}

TEST(Assign, LeavesRowsWithoutAColumnThatIsFree) {
  EXPECT_EQ(assign(Eigen::MatrixXd::Zero(2, 0)), (std::vector<Index>{-1, -1}));
  const std::vector<Index> two = assign(Eigen::MatrixXd::Zero(3, 2));
  EXPECT_EQ(std::ranges::count(two, -1), 1);
  Eigen::MatrixXd unknown = Eigen::MatrixXd::Zero(2, 2);
  unknown.row(1).setConstant(std::nan(""));
  EXPECT_EQ(assign(unknown)[1], -1);
}

TEST(Assign, IsAsCheapAsTheBestOfAllPermutations) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform;
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::MatrixXd cost =
        Eigen::MatrixXd::NullaryExpr(4, 6, [&] { return uniform(random); });
    std::vector<Index> order(6);
    std::iota(order.begin(), order.end(), Index{0});
    double best = 1e9;
    do {
      best = std::min(best, cost_of(cost, order));
    } while (std::ranges::next_permutation(order).found);
    // Both sum the same four numbers.
    EXPECT_NEAR(cost_of(cost, assign(cost)), best, 1e-12);
  }
}

Eigen::MatrixXcd shapes(Index n, Index m, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(n, m, [&] { return normal(random); })
      .cast<std::complex<double>>();
}

TEST(PairModes, FindsModesThatChangedTheirOrder) {
  const Eigen::MatrixXcd model = shapes(12, 4, 7);
  Eigen::MatrixXcd measured = model;
  measured.col(1) = -2.0 * model.col(2);
  measured.col(2) = model.col(1);
  Eigen::VectorXd f_model(4);
  f_model << 10.0, 20.0, 21.0, 40.0;
  Eigen::VectorXd f_measured(4);
  f_measured << 9.7, 19.6, 20.2, 38.0;
  const std::vector<Pair> pairs =
      pair_modes(measured, f_measured, model, f_model);
  ASSERT_EQ(pairs.size(), 4U);
  EXPECT_EQ(pairs[1].model, 2);
  EXPECT_EQ(pairs[2].model, 1);
  EXPECT_NEAR(pairs[1].mac, 1.0, 1e-12);
}

TEST(PairModes, LeavesOutWhatHasNoPartner) {
  const Eigen::MatrixXcd model = shapes(12, 3, 9);
  Eigen::MatrixXcd measured(12, 4);
  measured << model, shapes(12, 1, 99);
  Eigen::VectorXd f_model(3);
  f_model << 0.0, 20.0, 60.0;  // the first is a rigid body's
  Eigen::VectorXd f_measured(4);
  f_measured << 5.0, 20.0, 25.0, 21.0;
  const std::vector<Pair> pairs =
      pair_modes(measured, f_measured, model, f_model);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].measured, 1);
  EXPECT_EQ(pairs[0].model, 1);
}

TEST(PairModes, LittleLikenessFarApartIsNoPair) {
  Eigen::MatrixXcd model = Eigen::MatrixXcd::Zero(4, 1);
  model.topRows(3).setOnes();
  Eigen::MatrixXcd measured = Eigen::MatrixXcd::Zero(4, 1);
  measured(0, 0) = 1.0;  // MAC 1/3
  const Eigen::VectorXd f = Eigen::VectorXd::Constant(1, 10.0);
  EXPECT_EQ(pair_modes(measured, f, model, 1.2 * f).size(), 1U);
  EXPECT_TRUE(pair_modes(measured, f, model, 1.45 * f).empty());
}

TEST(PairModes, IsEmptyWithoutModes) {
  const Eigen::MatrixXcd none(5, 0);
  EXPECT_TRUE(
      pair_modes(none, Eigen::VectorXd(), none, Eigen::VectorXd()).empty());
}

TEST(PairModes, PairsSetByHandStand) {
  const Eigen::MatrixXcd model = shapes(12, 3, 7);
  const Eigen::VectorXd f = Eigen::Vector3d(10.0, 20.0, 30.0);
  // By MAC and frequency each would be its own.
  const std::vector<Pair> turned =
      pair_modes(model, f, model, f, {}, {{0, 1, 0.0}});
  ASSERT_EQ(turned.size(), 2U);
  EXPECT_EQ(turned[0].measured, 0);
  EXPECT_EQ(turned[0].model, 1);
  EXPECT_NEAR(turned[0].mac, modal::mac(model, model)(0, 1), 1e-14);
  EXPECT_EQ(turned[1].measured, 2);
  const std::vector<Pair> alone =
      pair_modes(model, f, model, f, {}, {{2, -1, 0.0}});
  ASSERT_EQ(alone.size(), 2U);
  EXPECT_EQ(alone[1].measured, 1);
}

TEST(PairModes, RefusesPairsThatCannotBe) {
  const Eigen::MatrixXcd model = shapes(12, 3, 7);
  const Eigen::VectorXd f = Eigen::Vector3d(10.0, 20.0, 30.0);
  EXPECT_THROW((void)pair_modes(model, f, model, f, {}, {{3, 0, 0.0}}),
               InputError);
  EXPECT_THROW(
      (void)pair_modes(model, f, model, f, {}, {{0, 1, 0.0}, {2, 1, 0.0}}),
      InputError);
}

}  // namespace
}  // namespace tapfit::modal
