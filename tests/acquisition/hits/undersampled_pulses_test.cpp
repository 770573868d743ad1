#include "acquisition/hits/undersampled_pulses.hpp"

#include "tests/acquisition/support/hammer_record.hpp"
#include "tests/support/matchers.hpp"

namespace tapfit::acquisition {
namespace {

constexpr double rate = 1000.0;

// Two hundred blows, each somewhere else between two samples.
Eigen::VectorXd blows(double samples, bool filter, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(200 * 100);
  for (int k = 0; k < 200; ++k) {
    testing::add_pulse(force,
                       rate,
                       (100 * k + 50 + uniform(random)) / rate,
                       samples / rate,
                       20.0,
                       filter);
  }
  testing::add_noise(force, 0.01, random);
  return force;
}

HammerRun run_of(const Eigen::VectorXd& force) {
  HammerRun run;
  run.hammer = prepare_hammer(force, rate);
  run.pulses.pulses = find_pulses(run.hammer.force, run.hammer.pieces, 4.0);
  return run;
}

std::string said_of(const Eigen::VectorXd& force) {
  return undersampled_statement({run_of(force)}, rate);
}

// The sum of a pulse's samples against its impulse, 2 w / pi of its peak.
TEST(ShortPulses, ImpulseErrorIsTheLargest) {
  for (const double w : {2.0, 3.0}) {
    double worst = 0.0;
    for (double phase = 0.0; phase < 1.0; phase += 0.01) {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(100);
      testing::add_pulse(
          force, rate, (50 + phase) / rate, w / rate, 1.0, false);
      worst = std::max(
          worst, std::abs(force.sum() * std::numbers::pi / (2.0 * w) - 1.0));
    }
    EXPECT_NEAR(worst, impulse_error(w), 1e-12);
  }
}

TEST(ShortPulses, AreSaidUnlessAFilterRings) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    for (const double w : {1.5, 2.0, 2.5}) {
      const std::string said = said_of(blows(w, false, seed));
      EXPECT_THAT(said, HasSubstr("no anti-alias filter")) << w;
      EXPECT_EQ(said_of(blows(w, true, seed)), "") << w;
    }
    EXPECT_EQ(said_of(blows(3.0, true, seed)), "");
    EXPECT_EQ(said_of(blows(6.0, false, seed)), "");
  }
  EXPECT_EQ(undersampled_statement({}, rate), "");
}

// A charge amplifier whose zero comes back over a few samples is no filter.
TEST(ShortPulses, AnUndershootIsNoRinging) {
  Eigen::VectorXd force = blows(2.0, false, 1);
  for (const Pulse& pulse : run_of(force).pulses.pulses) {
    for (Eigen::Index k = 2; k < 12; ++k) {
      force[pulse.peak + k] -=
          0.25 * pulse.height * std::exp(-0.6 * static_cast<double>(k - 2));
    }
  }
  EXPECT_NE(said_of(force), "");
}

}  // namespace
}  // namespace tapfit::acquisition
