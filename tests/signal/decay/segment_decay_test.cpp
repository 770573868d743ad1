// Decays of known rates and what is none.
#include "signal/decay/segment_decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace tapfit::signal {
namespace {

constexpr double dt = 1.0 / 512.0;
constexpr Eigen::Index samples = 4096;  // 8 s, segments of 1 s

Eigen::VectorXd decay(double hz, double rate, double amplitude) {
  Eigen::VectorXd x(samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * dt;
    x(i) = amplitude * std::exp(-rate * t) *
           std::sin(2.0 * std::numbers::pi * hz * t);
  }
  return x;
}

TEST(SegmentDecay, ThreeDecaysTellAll) {
  // One and its neighbours within a segment's main lobe, 2 Hz to either side;
  // one of them does not decay.
  const Eigen::VectorXd x =
      decay(20.0, 0.5, 1.0) + decay(20.3, 1.0, 0.7) + decay(21.0, 0.0, 0.2);
  EXPECT_TRUE(Segments(x, dt).course(20.0, 0.0).decays);
  // 3 % of white noise: 0.03 / sqrt(sum of w^2 = 192) of a line's level.
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Eigen::VectorXd noisy = x;
  for (double& value : noisy) value += 0.03 * normal(random);
  EXPECT_TRUE(Segments(noisy, dt).course(20.0, 0.03 * 0.03).decays);
}

TEST(SegmentDecay, AToneIsSteadyAndADecayFalls) {
  const SegmentDecay tone =
      Segments(decay(20.0, 0.0, 1.0), dt).course(20.0, 0.0);
  EXPECT_TRUE(tone.decays);
  EXPECT_TRUE(tone.steady);
  EXPECT_FALSE(tone.fall);
  const SegmentDecay one =
      Segments(decay(20.0, 0.6, 1.0), dt).course(20.0, 0.0);
  EXPECT_TRUE(one.decays);
  EXPECT_FALSE(one.steady);
  ASSERT_TRUE(one.fall);
  // Hann's sidelobes of the mirror image 40 lines off: below 1e-5.
  EXPECT_NEAR(one.fall->rate, 0.6, 1e-3);
  EXPECT_NEAR(one.fall->end_s, 7.5, 0.01);
}

// Struck again after 4 s: the fall ends there, its rate is the first one's.
TEST(SegmentDecay, ABlowThatComesAnewIsNoDecay) {
  Eigen::VectorXd x = decay(20.0, 1.0, 1.0);
  x.tail(samples / 2) += decay(20.0, 1.0, 0.8).head(samples / 2);
  const SegmentDecay course = Segments(x, dt).course(20.0, 0.0);
  EXPECT_FALSE(course.decays);
  EXPECT_FALSE(course.steady);
  ASSERT_TRUE(course.fall);
  EXPECT_NEAR(course.fall->rate, 1.0, 0.05);
  EXPECT_NEAR(course.fall->end_s, 3.5, 0.6);
}

// A decay into what wind makes of the same mode, 3 % of its start. Segments lie
// half over each other, so that the e_k are not quite independent: two
// deviations above hold in 9 of 10 and more instead of 97 of 100. A line
// through the levels as they bend falls too slowly.
TEST(SegmentDecay, ADecayIntoAFloorIsNotTakenForASlowerOne) {
  constexpr double rate = 1.2;
  const std::complex<double> step =
      std::exp(std::complex<double>(-rate, 2.0 * std::numbers::pi * 20.0) * dt);
  double mean = 0.0;
  int below = 0;
  constexpr int seeds = 400;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x = decay(20.0, rate, 1.0);
    const double size = 0.03 * std::sqrt(1.0 - std::norm(step));
    std::complex<double> z = 0.03 * normal(random);
    for (double& value : x) {
      z = step * z +
          size * std::complex<double>(normal(random), normal(random));
      value += z.imag();
    }
    const SegmentDecay course = Segments(x, dt).course(20.0, 0.0);
    ASSERT_TRUE(course.fall) << seed;
    mean += course.fall->rate / seeds;
    below += rate < course.fall->most ? 1 : 0;
    // exp(-1.2 t) = 0.03 at 2.9 s.
    EXPECT_NEAR(course.fall->end_s, 2.9, 1.5) << seed;
  }
  EXPECT_NEAR(mean, rate, 0.05 * rate);
  EXPECT_GE(below, 90 * seeds / 100);
}

TEST(SegmentDecay, TooFewSamplesTellNothing) {
  const SegmentDecay course =
      Segments(decay(20.0, 1.0, 1.0).head(100), dt).course(20.0, 0.0);
  EXPECT_TRUE(course.decays);
  EXPECT_FALSE(course.fall);
}

}  // namespace
}  // namespace tapfit::signal
