#include "signal/statistics/tail_probability.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tapfit::signal {
namespace {

TEST(TailProbability, HasTheTablesValues) {
  // NIST/SEMATECH e-Handbook, 1.3.6.7: upper critical values, printed to three
  // or four digits.
  EXPECT_NEAR(f_tail(4.351, 1, 20), 0.05, 2e-5);
  EXPECT_NEAR(f_tail(3.326, 5, 10), 0.05, 2e-5);
  EXPECT_NEAR(chi_squared_tail(18.307, 10), 0.05, 2e-5);
  EXPECT_NEAR(chi_squared_tail(6.635, 1), 0.01, 2e-5);
  EXPECT_NEAR(t_95(10), 2.228, 5e-4);
  EXPECT_NEAR(t_95(1), 12.706, 5e-4);
}

TEST(TailProbability, AgreesWithClosedForms) {
  // F(2, d): (1 + 2 f / d)^(-d / 2); chi^2 of 2 degrees of freedom: exp(-c/2).
  EXPECT_NEAR(f_tail(7.0, 2, 9), std::pow(1.0 + 14.0 / 9.0, -4.5), 1e-13);
  EXPECT_NEAR(
      f_tail(400.0, 2, 60) / std::pow(1.0 + 800.0 / 60.0, -30.0), 1.0, 1e-9);
  EXPECT_NEAR(chi_squared_tail(3.0, 2), std::exp(-1.5), 1e-13);
  EXPECT_NEAR(chi_squared_tail(90.0, 2) / std::exp(-45.0), 1.0, 1e-9);
}

// With 2 degrees of freedom above: (1 + 2 f / d)^(-d / 2); with 1 and 1 it is
// the square of Cauchy's: 1 - 2 / pi atan(sqrt(f)).
TEST(TailProbability, AgreesWithClosedFormsFromSmallToLargeF) {
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
TEST(TailProbability, OfFIsThatOfTheInverse) {
  for (const auto& [a, b] : {std::array{3.0, 2.0}, {7.0, 90.0}, {4.0, 20.0}}) {
    for (const double f : {0.2, 1.0, 2.3, 9.0}) {
      EXPECT_NEAR(f_tail(f, a, b) + f_tail(1.0 / f, b, a), 1.0, 1e-12);
    }
  }
}

TEST(TailProbability, IsOneForNothing) {
  EXPECT_EQ(f_tail(0.0, 3, 4), 1.0);
  EXPECT_EQ(chi_squared_tail(-1.0, 4), 1.0);
}

}  // namespace
}  // namespace tapfit::signal
