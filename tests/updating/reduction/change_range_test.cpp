// Bounds of what is added to two modes of 10 and 30 Hz.
#include "updating/reduction/change_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

ChangeRange range_of(const Eigen::Matrix2d& S) {
  const Eigen::MatrixXd shapes = Eigen::Matrix2d::Identity();
  const Eigen::VectorXd hz = Eigen::Vector2d(10.0, 30.0);
  return added_range(S.sparseView(), {shapes, hz, 100.0});
}

double square(double hz) { return std::pow(2.0 * M_PI * hz, 2); }

TEST(AddedRange, EndsAtTenTimesWhatDoublesAMode) {
  Eigen::Matrix2d S = Eigen::Vector2d(2.0, 4.0).asDiagonal();
  const ChangeRange range = range_of(S);
  EXPECT_NEAR(range.upper, 10.0 * square(10.0) / 2.0, 1e-9 * range.upper);
  EXPECT_NEAR(range.lower, 1e-5 * range.upper, 1e-9 * range.upper);
  EXPECT_EQ(range.absent, 0.0);
  EXPECT_EQ(range.included, 0.0);
}

// K - p [2 1; 1 4]: the least p at which it is singular, of both modes
// together, times 0.9.
TEST(AddedRange, EndsShortOfBuckling) {
  Eigen::Matrix2d S;
  S << -2.0, -1.0, -1.0, -4.0;
  const double a = square(10.0);
  const double b = square(30.0);
  // (a - 2 p) (b - 4 p) = p^2.
  const double half = (4.0 * a + 2.0 * b) / 14.0;
  const double buckles = half - std::sqrt(half * half - a * b / 7.0);
  const ChangeRange range = range_of(S);
  EXPECT_NEAR(range.upper, 0.9 * buckles, 1e-9 * buckles);
  EXPECT_LT(range.lower, range.start);
  EXPECT_LT(range.start, range.upper);
}

}  // namespace
}  // namespace tapfit::updating
