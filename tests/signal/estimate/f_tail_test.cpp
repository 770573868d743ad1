#include "signal/estimate/f_tail.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tapfit::signal {
namespace {

// With 2 degrees of freedom above: (1 + 2 f / d)^(-d / 2); with 1 and 1 it is
// the square of Cauchy's: 1 - 2 / pi atan(sqrt(f)).
TEST(FTail, IsTheClosedForm) {
  for (const double f : {0.01, 0.3, 1.0, 4.0, 50.0, 1e4}) {
    for (const double d : {1.0, 2.0, 5.0, 40.0, 300.0}) {
      const double closed = std::pow(1.0 + 2.0 * f / d, -0.5 * d);
      EXPECT_NEAR(f_tail(f, 2.0, d) / closed, 1.0, 1e-10) << f << " " << d;
    }
    EXPECT_NEAR(
        f_tail(f, 1.0, 1.0), 1.0 - 2.0 / M_PI * std::atan(std::sqrt(f)), 1e-12);
  }
}

// P(F_{a,b} > f) + P(F_{b,a} > 1 / f) = 1.
TEST(FTail, IsThatOfTheInverse) {
  for (const auto& [a, b] : {std::array{3.0, 2.0}, {7.0, 90.0}, {4.0, 20.0}}) {
    for (const double f : {0.2, 1.0, 2.3, 9.0}) {
      EXPECT_NEAR(f_tail(f, a, b) + f_tail(1.0 / f, b, a), 1.0, 1e-12);
    }
  }
}

TEST(FTail, IsOneForNothing) { EXPECT_EQ(f_tail(0.0, 3.0, 4.0), 1.0); }

}  // namespace
}  // namespace tapfit::signal
