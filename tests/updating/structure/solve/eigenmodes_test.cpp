#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/progress.hpp"
#include "tests/updating/support/clamped_line.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/factor.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <random>
#include <stop_token>
#include <vector>

namespace tapfit::structure {
namespace {

TEST(Factor, SolvesDefiniteAndIndefiniteSystems) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd A =
      Eigen::MatrixXd::NullaryExpr(30, 30, [&] { return normal(random); });
  A = (A + A.transpose()).eval();
  const Eigen::MatrixXd B =
      Eigen::MatrixXd::NullaryExpr(30, 4, [&] { return normal(random); });
  const Factor indefinite(sparse(A));
  // No pivoting: a few digits are lost on a random matrix.
  EXPECT_LT((A * indefinite.solve(B) - B).norm(), 1e-8 * B.norm());
  const Eigen::MatrixXd P = A * A.transpose();
  const Factor definite(sparse(P));
  EXPECT_LT((P * definite.solve(B) - B).norm(), 1e-8 * B.norm());
}

TEST(Factor, RefusesAMechanism) {
  Eigen::Matrix3d A;
  A << 1, -1, 0, -1, 2, -1, 0, -1, 1;  // a free chain
  EXPECT_THROW(Factor(sparse(A)), InputError);
  EXPECT_THROW(Factor(sparse(Eigen::Matrix3d::Zero())), InputError);
  Factor moved(sparse(Eigen::Matrix3d::Identity()));
  const Factor taken = std::move(moved);
  EXPECT_EQ(taken.solve(Eigen::Vector3d::Ones()), Eigen::Vector3d::Ones());
}

// The definition: K phi = omega^2 M phi, phi' M phi = I.
void expect_modes(const SparseMatrix& K,
                  const SparseMatrix& M,
                  const Eigenmodes& modes) {
  const Eigen::Index n = modes.frequency_hz.size();
  const Eigen::MatrixXd unit = modes.phi.transpose() * (M * modes.phi);
  EXPECT_LT((unit - Eigen::MatrixXd::Identity(n, n)).norm(), 1e-9);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double lambda = std::pow(2 * M_PI * modes.frequency_hz(i), 2);
    const Eigen::VectorXd force = K * modes.phi.col(i);
    const Eigen::VectorXd residual = force - lambda * (M * modes.phi.col(i));
    // Forces cancel within K's rows; what is left is its rounding.
    EXPECT_LT(residual.norm(), 1e-6 * std::max(force.norm(), 1.0)) << i;
    EXPECT_GE(modes.frequency_hz(i),
              modes.frequency_hz(std::max<Eigen::Index>(i - 1, 0)));
  }
}

TEST(Eigenmodes, HoldsTheDefinitionForLargeAndSmallModels) {
  for (const int n : {3, 16}) {
    Deck deck = plate_deck({.b = 0.8}, n, n);
    hold(deck, "123456", [](const Eigen::Vector3d& p) { return p.x() < 1e-9; });
    const System system = assemble(deck);
    const std::vector<int> free = system.free_dofs();
    const SparseMatrix K = extract(system.K, free);
    const SparseMatrix M = extract(system.M, free);
    expect_modes(K, M, eigenmodes(K, M, 20));
  }
}

TEST(Eigenmodes, FindsSixRigidModesAndTwins) {
  // A free square plate: every second bending mode has a twin.
  const Eigen::VectorXd f = modes_of(plate_deck({}, 14, 14), 30).frequency_hz;
  EXPECT_LT(f.head(6).maxCoeff(), 1e-3 * f(6));
  EXPECT_GT(f(6), 1.0);
  EXPECT_NEAR(f(9), f(10), 1e-6 * f(9));
}

// Fewer than there are of one frequency, which rounding alone sets apart.
TEST(Eigenmodes, FindsSomeOfTheRigidModes) {
  const Deck deck = plate_deck({.b = 0.8}, 16, 16);
  const System system = assemble(deck);
  for (const int count : {1, 2, 3, 4, 5, 6, 7}) {
    const Eigenmodes modes = eigenmodes(system.K, system.M, count);
    ASSERT_EQ(modes.frequency_hz.size(), count);
    EXPECT_LT(modes.frequency_hz(std::min(count, 6) - 1), 0.1);
  }
}

TEST(Eigenmodes, EndsWhereItsUserAskedItTo) {
  const System system = assemble(plate_deck({.b = 0.8}, 16, 16));
  std::stop_source user;
  user.request_stop();
  EXPECT_THROW(eigenmodes(system.K, system.M, 7, user.get_token()), Stopped);
}

TEST(Eigenmodes, FindsEverythingUpToAFrequency) {
  const System system = assemble(plate_deck({}, 10, 10));
  const std::vector<int> free = system.free_dofs();
  const SparseMatrix K = extract(system.K, free);
  const SparseMatrix M = extract(system.M, free);
  const Eigen::VectorXd all = eigenmodes(K, M, 25).frequency_hz;
  const double limit = 0.5 * (all(19) + all(20));
  ASSERT_GT(all(20) - all(19), 1e-3 * all(20));
  EXPECT_EQ(eigenmodes_up_to(K, M, limit).frequency_hz.size(), 20);
}

TEST(Eigenmodes, CutsTheCountToWhatThereIs) {
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  M(0, 0) = 1.0;
  M(1, 1) = 4.0;
  const Eigen::Matrix3d K = 16.0 * Eigen::Matrix3d::Identity();
  const Eigenmodes modes = eigenmodes(sparse(K), sparse(M), 10);
  ASSERT_EQ(modes.frequency_hz.size(), 2);
  EXPECT_NEAR(modes.frequency_hz(0), 2 / (2 * M_PI), 1e-9);
  EXPECT_NEAR(modes.frequency_hz(1), 4 / (2 * M_PI), 1e-9);
}

// Three masses on a plate that weighs nothing: as many modes as these can move
// in ways, and none of infinite frequency among them.
TEST(Eigenmodes, FindsTheFewOfFewMasses) {
  Deck deck = plate_deck({}, 8, 8);
  deck.materials[1].rho = 0.0;
  hold(deck, "123456", [](const Eigen::Vector3d& p) { return p.x() < 1e-9; });
  for (const int grid : {40, 60, 81}) {
    PointMass mass;
    mass.id = 100 + grid;
    mass.grid = grid;
    mass.mass = 0.1;
    deck.masses.push_back(mass);
  }
  const System system = assemble(deck);
  const std::vector<int> free = system.free_dofs();
  const SparseMatrix K = extract(system.K, free);
  const SparseMatrix M = extract(system.M, free);
  const Eigenmodes modes = eigenmodes(K, M, 20);
  EXPECT_EQ(modes.frequency_hz.size(), 9);
  expect_modes(K, M, modes);
}

// Euler-Bernoulli, f = (beta L)^2 / 2 pi L^2 sqrt(E I / rho A), about both
// axes. Of 3000 bars the lowest has 12.4 / 24 n^4 = 6e-15 of the energies that
// cancel in it, of which rounding is 2e-16: 2 % of a frequency; the sixth has
// 200 times as much.
TEST(Eigenmodes, FindsTheLowestOfALongLine) {
  constexpr std::array<double, 4> roots{
      1.875104069, 4.694091133, 7.854757438, 10.99554073};
  constexpr int bars = 3000;
  constexpr double bar_m = 0.01;
  std::vector<double> expected;
  for (const double side : {0.01, 0.02}) {
    for (const double root : roots) {
      expected.push_back(root * root /
                         (2.0 * M_PI * std::pow(bars * bar_m, 2)) *
                         std::sqrt(2.1e11 / 7850.0 / 12.0) * side);
    }
  }
  std::sort(expected.begin(), expected.end());
  const Eigen::VectorXd found =
      modes_of(clamped_line(bars, bar_m), 6).frequency_hz;
  ASSERT_EQ(found.size(), 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const double f = found(static_cast<Eigen::Index>(i));
    EXPECT_NEAR(f, expected[i], (i < 2 ? 2e-2 : 1e-3) * expected[i]) << i;
  }
}

// 20,000 of 40,000 masses that swing by themselves at w = 1, 2, 3 ...: said
// before it is tried.
TEST(Eigenmodes, RefusesMoreThanAMachineTakes) {
  constexpr Eigen::Index masses = 40000;
  SparseMatrix K(masses, masses);
  SparseMatrix M(masses, masses);
  for (Eigen::Index i = 0; i < masses; ++i) {
    const auto w = static_cast<double>(i + 1);
    K.insert(i, i) = w * w;
    M.insert(i, i) = 1.0;
  }
  try {
    static_cast<void>(eigenmodes_up_to(K, M, 20000.5 / (2.0 * M_PI)));
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("20000 modes below"));
  }
}

TEST(Extract, TakesRowsAndColumns) {
  Eigen::Matrix3d A;
  A << 1, 2, 3, 2, 5, 6, 3, 6, 9;
  const Eigen::MatrixXd part = extract(sparse(A), {2, 0});
  EXPECT_EQ(part, (Eigen::Matrix2d() << 9, 3, 3, 1).finished());
}

// More modes asked for than have mass, with more masses than are solved for by
// themselves: a row of masses on springs with as many massless grids between.
// Of 2 n springs in a row, held at both ends,
//
//   w_k = 2 sqrt(k / 2 m) sin(k pi / 2 (n + 1)),  two springs in line being
//   half
TEST(Eigenmodes, EndsWhereNothingHasMassAnyMore) {
  constexpr Eigen::Index masses = 260;
  constexpr Eigen::Index n = 2 * masses + 1;
  std::vector<Eigen::Triplet<double>> k;
  std::vector<Eigen::Triplet<double>> m;
  for (Eigen::Index i = 0; i < n; ++i) {
    k.emplace_back(i, i, 2.0);
    if (i + 1 < n) {
      k.emplace_back(i, i + 1, -1.0);
      k.emplace_back(i + 1, i, -1.0);
    }
    if (i % 2 == 1) m.emplace_back(i, i, 1.0);
  }
  SparseMatrix K(n, n);
  SparseMatrix M(n, n);
  K.setFromTriplets(k.begin(), k.end());
  M.setFromTriplets(m.begin(), m.end());
  for (const Eigen::Index count : {200, 240}) {
    const Eigenmodes modes = eigenmodes(K, M, count);
    ASSERT_EQ(modes.frequency_hz.size(), count);
    for (const Eigen::Index mode : {Eigen::Index{0}, count - 1}) {
      const double w = 2.0 * std::sqrt(0.5) *
                       std::sin((static_cast<double>(mode) + 1.0) * M_PI /
                                (2.0 * (masses + 1)));
      EXPECT_NEAR(modes.frequency_hz(mode) * 2.0 * M_PI, w, 1e-7 * w) << mode;
    }
  }
}

}  // namespace
}  // namespace tapfit::structure
