#include "acquisition/checks/tip_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace tapfit::acquisition {
namespace {

/// Runs of two blows each, as long as that between their 10 % points.
HitSet blows(const std::vector<double>& lengths_s) {
  HitSet set;
  set.usable_bandwidth_hz = 800.0;
  for (const double length : lengths_s) {
    Hit hit;
    hit.pulse_s = length;
    set.runs.push_back({hit, hit});
  }
  return set;
}

// |sum of a half sine's samples times exp(-j 2 pi f t)| over its sum.
double level_of_half_sine(double hz, double length_s) {
  constexpr int steps = 20000;
  std::complex<double> sum = 0.0;
  double rest = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps;
    const double f = std::sin(std::numbers::pi * t);
    sum += f * std::polar(1.0, -2.0 * std::numbers::pi * hz * t * length_s);
    rest += f;
  }
  return std::abs(sum) / rest;
}

TEST(TipChange, ForceThatIsLostIsThatOfTwoHalfSines) {
  // Share of a half sine between its 10 % points.
  const double seen = 1.0 - 2.0 * std::asin(0.1) / std::numbers::pi;
  for (const double hz : {50.0, 200.0, 500.0, 990.0}) {
    const double expected = 20.0 * std::log10(level_of_half_sine(hz, 0.5e-3) /
                                              level_of_half_sine(hz, 1e-3));
    EXPECT_NEAR(force_lost_db(hz, seen * 1e-3, seen * 0.5e-3), expected, 1e-3)
        << hz;
  }
}

TEST(TipChange, IsFoundAtTheRunFromWhichOnBlowsAreOthers) {
  const auto softer =
      tip_change(blows({1.0e-3, 1.1e-3, 0.9e-3, 2.0e-3, 1.9e-3, 2.2e-3}));
  ASSERT_TRUE(softer);
  EXPECT_EQ(softer->first, 3U);
  EXPECT_DOUBLE_EQ(softer->before_s, 1.0e-3);
  EXPECT_DOUBLE_EQ(softer->after_s, 2.0e-3);
  const auto harder =
      tip_change(blows({2.0e-3, 1.9e-3, 0.9e-3, 1.0e-3, 1.1e-3}));
  ASSERT_TRUE(harder);
  EXPECT_EQ(harder->first, 2U);
}

// Points that give more, here and there; a little more from one on; too few.
TEST(TipChange, IsNotFoundWherePointsDifferOnly) {
  EXPECT_FALSE(tip_change(blows({1e-3, 2e-3, 1e-3, 2e-3, 1e-3, 2e-3})));
  EXPECT_FALSE(
      tip_change(blows({1.0e-3, 1.0e-3, 1.0e-3, 1.2e-3, 1.2e-3, 1.2e-3})));
  EXPECT_FALSE(tip_change(blows({1e-3, 1e-3, 2e-3, 2e-3})));
  EXPECT_FALSE(tip_change(blows({1e-3, 1e-3, 1e-3, 1e-3, 2e-3})));
}

TEST(TipChange, IsAWarningWhereForceIsLostInTheBand) {
  TestBundle bundle;
  const HitSet hits = blows({1.0e-3, 1.0e-3, 1.0e-3, 2.0e-3, 2.0e-3, 2.0e-3});
  bundle.band_hz = {20.0, 100.0};
  const auto note = tip_change_findings(bundle, hits);
  ASSERT_EQ(note.size(), 1U);
  EXPECT_EQ(note[0].severity, Severity::Note);
  EXPECT_EQ(note[0].where.runs, (std::vector<std::size_t>{3, 4, 5}));
  EXPECT_NE(note[0].likely.find("softer tip"), std::string::npos);
  bundle.band_hz.reset();  // 800 Hz
  const auto warning = tip_change_findings(bundle, hits);
  ASSERT_EQ(warning.size(), 1U);
  EXPECT_EQ(warning[0].severity, Severity::Warning);
}

}  // namespace
}  // namespace tapfit::acquisition
