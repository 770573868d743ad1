#include "updating/residual/residual.hpp"

#include "acquisition/foundation/seeded_random.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tapfit::updating
