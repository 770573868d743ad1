// Oracles: the rate that a decay was made with, and that what does not decay is
// none.
#include "acquisition/samples/octave_decay.hpp"

#include "tests/acquisition/support/hammer_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::acquisition {
namespace {

constexpr double rate_hz = 2048.0;
constexpr std::array band_hz = {5.0, 150.0};

Eigen::VectorXd silence(double seconds) {
  return Eigen::VectorXd::Zero(std::llround(seconds * rate_hz));
}

void add_tone(Eigen::VectorXd& x, double hz, double amplitude) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x(i) += amplitude * std::sin(2.0 * std::numbers::pi * hz *
                                 static_cast<double>(i) / rate_hz);
  }
}

TEST(SlowestDecay, IsFoundUnderHumDriftAndNoise) {
  std::mt19937_64 random(3);
  Eigen::VectorXd x = silence(8.0);
  testing::add_response(x, rate_hz, 0.0, 81.2, 2.55, 1.0);
  testing::add_response(x, rate_hz, 0.0, 12.3, 0.773, 0.1);
  add_tone(x, 50.0, 0.02);
  add_tone(x, 0.08, 0.3);
  testing::add_noise(x, 0.003, random);
  const auto decay = slowest_decay(x, rate_hz, band_hz);
  ASSERT_TRUE(decay);
  // Some ten windows, each known to 1 dB of the 20 they fall.
  EXPECT_NEAR(decay->rate, 0.773, 0.1 * 0.773);
  EXPECT_LT(decay->octave_hz[0], 12.3);
  EXPECT_GT(decay->octave_hz[1], 12.3);
}

TEST(SlowestDecay, IsNotLookedForOutsideTheBand) {
  Eigen::VectorXd x = silence(8.0);
  testing::add_response(x, rate_hz, 0.0, 40.0, 3.0, 1.0);
  testing::add_response(x, rate_hz, 0.0, 500.0, 1.0, 1.0);
  testing::add_response(x, rate_hz, 0.0, 2.5, 0.9, 1.0);
  const auto decay = slowest_decay(x, rate_hz, {20.0, 100.0});
  ASSERT_TRUE(decay);
  EXPECT_NEAR(decay->rate, 3.0, 0.1 * 3.0);
}

TEST(SlowestDecay, NoiseHumAndDriftAreNone) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    Eigen::VectorXd x = silence(8.0);
    add_tone(x, 50.0, 1.0);
    add_tone(x, 0.08, 3.0);
    testing::add_noise(x, 0.1, random);
    EXPECT_FALSE(slowest_decay(x, rate_hz, band_hz)) << seed;
  }
}

TEST(SlowestDecay, OfNothingIsNone) {
  EXPECT_FALSE(slowest_decay(silence(8.0), rate_hz, band_hz));
  EXPECT_FALSE(slowest_decay(silence(0.01), rate_hz, band_hz));
}

}  // namespace
}  // namespace tapfit::acquisition
