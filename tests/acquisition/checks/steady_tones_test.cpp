// Blows on a ringing structure, with and without a tone.
#include "acquisition/checks/steady_tones.hpp"

#include "tests/acquisition/support/hammer_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double rate = 1024.0;

VectorXd noise(Index count, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  VectorXd x(count);
  for (double& value : x) value = normal(engine);
  return x;
}

VectorXd tone(Index count, double hz, double decay_per_s) {
  VectorXd x(count);
  for (Index i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / rate;
    x(i) = std::exp(-decay_per_s * t) *
           std::sin(2.0 * std::numbers::pi * hz * t + 0.4);
  }
  return x;
}

// The false alarm is one in 1e9.
TEST(SteadyTone, IsNoneInNoiseAndDrift) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    VectorXd x = noise(1200, seed);
    EXPECT_FALSE(steady_tone(x, rate)) << seed;
    x += VectorXd::LinSpaced(1200, 0.0, 50.0);
    EXPECT_FALSE(steady_tone(x, rate)) << seed;
    // Two periods within the stretch.
    EXPECT_FALSE(
        steady_tone(x + 20.0 * tone(1200, 2.0 * rate / 1200.0, 0.0), rate))
        << seed;
  }
}

// Amplitude 1 in noise of sd 1 over n = 1200: sd of the amplitude
// sqrt(2 / n) = 0.04, of the frequency sqrt(6 / n^3) rate / pi = 0.02 Hz.
TEST(SteadyTone, HasItsFrequencyAndSize) {
  const VectorXd x = noise(1200, 3) + tone(1200, 61.3, 0.0);
  const auto found = steady_tone(x, rate);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->hz, 61.3, 0.1);
  EXPECT_NEAR(found->rms, std::numbers::sqrt2 / 2.0, 0.15);
}

// Long stretches are thinned to means.
TEST(SteadyTone, IsHeardInLongStretches) {
  const VectorXd x = noise(20000, 4) + tone(20000, 50.0, 0.0);
  const auto found = steady_tone(x, rate);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->hz, 50.0, 0.1);
}

TEST(SteadyTone, DoesNotDecay) {
  EXPECT_FALSE(
      steady_tone(noise(1200, 5) * 0.01 + tone(1200, 40.0, 2.0), rate));
}

// One blow at 1 s on one mode of 33 Hz, two sensors.
struct Blow {
  TestBundle bundle = testing::hammer_bundle();
  std::vector<Recording> recordings{1};
  HitSet hits;

  explicit Blow(double hum) {
    bundle.runs.resize(1);
    recordings[0].sample_rate_hz = rate;
    recordings[0].samples = Eigen::MatrixXd::Zero(8192, 2);
    VectorXd x = VectorXd::Zero(8192);
    testing::add_response(x, rate, 1.0, 33.0, 1.0, 1.0);
    const double level = std::sqrt(x.tail(8192 - 1024).squaredNorm() / 7168.0);
    recordings[0].samples.col(1) =
        x + 0.01 * level * noise(8192, 6) +
        hum * level * std::numbers::sqrt2 * tone(8192, 50.0, 0.0);
    hits.sample_rate_hz = rate;
    hits.block = 4096;
    hits.runs.resize(1);
    Hit hit;
    hit.trigger = 1024;
    hit.pulse_s = 2e-3;
    hits.runs[0].push_back(hit);
  }
  [[nodiscard]] std::vector<Finding> findings() const {
    return tone_findings(bundle, recordings, hits);
  }
};

TEST(ToneFindings, SayHumThatIsWorthIt) {
  EXPECT_TRUE(Blow(0.0).findings().empty());
  EXPECT_TRUE(Blow(0.02).findings().empty());
  const std::vector<Finding> said = Blow(0.2).findings();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].what.find("steady tone of 50 Hz"), std::string::npos)
      << said[0].what;
  EXPECT_NE(said[0].likely.find("mains hum"), std::string::npos);
  EXPECT_EQ(said[0].where.runs, std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace tapfit::acquisition
