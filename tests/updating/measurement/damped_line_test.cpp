#include "updating/measurement/damped_line.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tapfit::updating {
namespace {

TEST(DampedLineTest, CoversTheBandWithConstantRelativeWidth) {
  const Eigen::VectorXcd s = damped_line({10.0, 100.0}, 100.0, {0.03, 1000});
  EXPECT_NEAR(s(0).imag(), 2.0 * std::numbers::pi * 10.0, 1e-9);
  EXPECT_LE(s(s.size() - 1).imag(), 2.0 * std::numbers::pi * 100.0 * 1.0001);
  for (Eigen::Index k = 0; k < s.size(); ++k) {
    EXPECT_NEAR(s(k).real() / s(k).imag(), 0.03, 1e-12);
  }
}

TEST(DampedLineTest, WindowHasDecayedAtTheBlocksEnd) {
  const Eigen::VectorXcd s = damped_line({1.0, 100.0}, 2.0, {0.03, 1000});
  EXPECT_GE(s.real().minCoeff() * 2.0, 5.0 - 1e-12);
}

TEST(DampedLineTest, KeepsToTheNumberOfLines) {
  const Eigen::VectorXcd s = damped_line({1.0, 1000.0}, 1e3, {0.01, 100});
  EXPECT_LE(s.size(), 100);
  EXPECT_GE(s.size(), 95);
}

}  // namespace
}  // namespace tapfit::updating
