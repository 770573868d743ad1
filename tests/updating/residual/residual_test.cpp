#include "updating/residual/independent_data.hpp"
#include "updating/residual/residual.hpp"

#include "acquisition/foundation/seeded_random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

constexpr Eigen::Index lines = 60;
constexpr Eigen::Index frfs = 40;

// Lines so far apart that each is worth its two data.
Target plain_target() {
  Target target;
  target.s.resize(lines);
  for (Eigen::Index l = 0; l < lines; ++l) {
    target.s(l) = {0.01, 10.0 * static_cast<double>(l + 1)};
  }
  target.H = Eigen::MatrixXcd::Ones(lines, frfs);
  target.weight = Eigen::VectorXd::Ones(lines);
  target.use.assign(frfs, 1.0);
  target.run.assign(frfs, 0);
  return target;
}

Eigen::MatrixXcd noise() {
  acquisition::SeededRandom random(3, "residual");
  Eigen::MatrixXcd R(lines, frfs);
  for (auto& value : R.reshaped()) value = {random.normal(), random.normal()};
  return R;
}

TEST(Residual, NormOfTheStackIsTheRelativeError) {
  const Target target = plain_target();
  const Eigen::MatrixXcd H = target.H + 0.1 * noise();
  EXPECT_NEAR(
      stack(target, H - target.H).norm(), relative_error(target, H), 1e-12);
}

TEST(ResidualData, NoiseIsWorthAllOfIt) {
  const Target target = plain_target();
  EXPECT_GT(residual_data(target, stack(target, noise())),
            0.5 * effective_data(target));
}

TEST(ResidualData, OnePatternIsWorthTwo) {
  const Target target = plain_target();
  const Eigen::MatrixXcd R = noise();
  const Eigen::MatrixXcd pattern = R.col(0) * R.row(0);
  // 1 / P = 1, less 1 / 60 + 1 / 40 for what noise alone would add.
  EXPECT_NEAR(residual_data(target, stack(target, pattern)), 2.18, 0.05);
}

/// Three frequencies of 0.1, 0.2 and 0.2 % and shapes at two points.
ModalData three_modes() {
  ModalData data;
  data.sd = std::sqrt((0.01 + 0.04 + 0.04) / 3.0) * 1e-2;
  data.frequency_hz = Eigen::Vector3d(10.0, 20.0, 40.0);
  data.frequency_weight = data.sd * Eigen::Vector3d(1e3, 500.0, 500.0);
  data.dofs = {{1, 3, 1}, {2, 3, 1}};
  data.shape = Eigen::MatrixXd::Constant(2, 3, M_SQRT1_2);
  data.shape_weight = Eigen::MatrixXd::Constant(2, 3, data.sd / 0.05);
  return data;
}

// Each as it is defined: data in units of their standard deviation, times sd.
TEST(ModalTarget, OneStandardDeviationOffIsWorthOneSd) {
  const ModalData data = three_modes();
  const Target target = make_target(data);
  ASSERT_TRUE(target.is_modal());
  Eigen::MatrixXcd H = target.H;
  EXPECT_EQ(relative_error(target, H), 0.0);
  // The first frequency by its 0.1 %, a value of the second shape by its 0.05.
  H(0, 0) = data.frequency_weight(0) * std::log(10.0 * 1.001);
  H(1, 2) += data.shape_weight(1, 1) * 0.05;
  // Two of nine values are off by 1; ln 1.001 is 0.001 to a part in 2000.
  EXPECT_NEAR(relative_error(target, H),
              data.sd * std::sqrt(2.0 / 9.0),
              1e-3 * data.sd);
  const Eigen::VectorXd r = residual(target, H);
  EXPECT_NEAR(error_of(target, r), relative_error(target, H), 1e-12);
}

TEST(ModalTarget, AModelThatIsRightLeavesTheScatterOfItsData) {
  const Target target = make_target(three_modes());
  // A shape's factor takes one of its two values: of nine data six are free.
  EXPECT_NEAR(
      noise_error(target), three_modes().sd * std::sqrt(6.0 / 9.0), 1e-12);
  // Those six, and ten readings of what is stated.
  EXPECT_EQ(effective_data(target), 16.0);
  // The stated scatter keeps the residual from zero, worth ten data.
  const Eigen::VectorXd r = residual(target, target.H);
  EXPECT_EQ(error_of(target, r), 0.0);
  EXPECT_NEAR(
      r.squaredNorm(), std::pow(three_modes().sd, 2) * 10.0 / 9.0, 1e-15);
  EXPECT_EQ(stack(target, Eigen::MatrixXcd::Zero(3, 3)).size(), r.size());
}

TEST(ModalTarget, FrequenciesAloneAreADatumEach) {
  ModalData data = three_modes();
  data.dofs.clear();
  data.shape.resize(0, 3);
  data.shape_weight.resize(0, 3);
  const Target target = make_target(data);
  EXPECT_EQ(effective_data(target), 13.0);
  EXPECT_NEAR(noise_error(target), data.sd, 1e-12);
}

}  // namespace
}  // namespace tapfit::updating
