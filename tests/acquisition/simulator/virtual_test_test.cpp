#include "acquisition/simulator/virtual_test.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/samples/anti_alias.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::acquisition {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// One mass on a spring, its own acceleration measured.
SecondOrderSystem single(double m, double hz, double zeta) {
  const double w = 2.0 * pi * hz;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  return {m * one,
          2.0 * zeta * w * m * one,
          w * w * m * one,
          Eigen::VectorXd::Ones(1),
          one};
}

/// Two coupled masses with a dashpot that is not proportional; force on the
/// first, both measured.
SecondOrderSystem pair() {
  SecondOrderSystem system;
  system.M = Eigen::Vector2d(1.0, 0.5).asDiagonal();
  system.K =
      (Eigen::Matrix2d() << 9000.0, -4000.0, -4000.0, 30000.0).finished();
  system.C = (Eigen::Matrix2d() << 9.0, -1.0, -1.0, 4.0).finished();
  system.input = Eigen::Vector2d(1.0, 0.0);
  system.output = Eigen::Matrix2d::Identity();
  return system;
}

Eigen::VectorXcd accelerance(const SecondOrderSystem& system, double hz) {
  const Complex s(0.0, 2.0 * pi * hz);
  const Eigen::MatrixXcd Z = system.M.cast<Complex>() * s * s +
                             system.C.cast<Complex>() * s +
                             system.K.cast<Complex>();
  return s * s *
         (system.output.cast<Complex>() *
          Z.partialPivLu().solve(system.input.cast<Complex>()));
}

Eigen::RowVectorXcd transform(const Eigen::MatrixXd& x,
                              double hz,
                              double rate) {
  Eigen::RowVectorXcd sum = Eigen::RowVectorXcd::Zero(x.cols());
  for (Eigen::Index n = 0; n < x.rows(); ++n) {
    const double t = static_cast<double>(n) / rate;
    sum += std::polar(1.0, -2.0 * pi * hz * t) * x.row(n);
  }
  return sum;
}

TEST(ExactResponse, RampIsExact) {
  // Undamped: a = sin(w t) w / k for f = t. The hold is exact for a ramp, so
  // only rounding over 2000 steps is left.
  const SecondOrderSystem system = single(2.0, 3.0, 0.0);
  const double w = 2.0 * pi * 3.0;
  const Eigen::VectorXd force = Eigen::VectorXd::LinSpaced(2001, 0.0, 2.0);
  const Eigen::MatrixXd a = exact_response(system, force, 1000.0)->acceleration;
  for (Eigen::Index n = 0; n < force.size(); n += 7) {
    EXPECT_NEAR(a(n, 0), std::sin(w * force(n)) * w / (2.0 * w * w), 1e-11);
  }
}

TEST(ExactResponse, HalfSineMatchesClosedForm) {
  // During sin(W t): particular plus free solution from rest, in closed form.
  const double zeta = 0.05;
  const double w = 2.0 * pi * 20.0;
  const double W = pi / 0.008;
  const SecondOrderSystem system = single(0.4, 20.0, zeta);
  const double rate = 50000.0;
  const Eigen::Index pulse = 400;
  Eigen::VectorXd force(pulse);
  for (Eigen::Index n = 0; n < pulse; ++n) {
    force(n) = std::sin(W * static_cast<double>(n) / rate);
  }
  const Eigen::MatrixXd a = exact_response(system, force, rate)->acceleration;

  const Complex s(-zeta * w, w * std::sqrt(1.0 - zeta * zeta));
  const Complex H =
      1.0 / (0.4 * (w * w - W * W + Complex(0.0, 2.0 * zeta * w * W)));
  // q = Im(H e^(iWt)) + Re(c e^(st)) with q(0) = q'(0) = 0.
  const double q0 = -H.imag();
  const double v0 = -(Complex(0.0, W) * H).imag();
  const Complex c(q0, (s.real() * q0 - v0) / s.imag());
  for (Eigen::Index n = 0; n < pulse; n += 13) {
    const double t = static_cast<double>(n) / rate;
    const double exact = (-W * W * H * std::polar(1.0, W * t)).imag() +
                         (s * s * c * std::exp(s * t)).real();
    // Straight lines between samples miss a sine by (W h)^2 / 8 = 8e-6.
    EXPECT_NEAR(a(n, 0), exact, 2e-5);
  }
}

TEST(ExactResponse, FreeDecayHasTheDamping) {
  const SecondOrderSystem system = single(1.0, 10.0, 0.02);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(20000);
  force(1) = 1.0;
  const Eigen::MatrixXd a =
      exact_response(system, force, 10000.0)->acceleration;
  // Whole damped periods apart: the ratio is e^(-2 pi n zeta / sqrt(1-zeta^2)).
  const double period = 0.1 / std::sqrt(1.0 - 0.02 * 0.02);
  const double early = a.middleRows(2000, 1000).cwiseAbs().maxCoeff();
  const double late = a.middleRows(12000, 1000).cwiseAbs().maxCoeff();
  // Peaks are met to within half a sample of 1000 per period: 5e-6.
  EXPECT_NEAR(std::log(early / late), 2.0 * pi * 0.02 * 10.0, 2e-3);
  EXPECT_NEAR(period, 0.1, 1e-4);
}

TEST(ExactResponse, CriticalDampingIsRefused) {
  EXPECT_FALSE(
      exact_response(single(1.0, 5.0, 1.0), Eigen::VectorXd::Ones(10), 100.0));
}

TEST(DampedPoles, OfOneMass) {
  const SecondOrderSystem system = single(3.0, 7.5, 0.004);
  const DampedPoles poles = damped_poles(system.M, system.C, system.K);
  ASSERT_EQ(poles.frequency_hz.size(), 1);
  EXPECT_NEAR(poles.frequency_hz(0), 7.5, 1e-12);
  EXPECT_NEAR(poles.damping_ratio(0), 0.004, 1e-12);
}

TEST(AntiAlias, PassesTheBandAndStopsTheRest) {
  for (const int oversampling : {8, 16}) {
    const Eigen::VectorXd taps = anti_alias_taps(oversampling);
    const auto gain = [&](double fraction) {
      return std::abs(transform(taps, fraction / oversampling, 1.0)(0));
    };
    // The window is designed for 100 dB; ripple in pass and stop band alike.
    EXPECT_NEAR(gain(0.0), 1.0, 1e-12);
    EXPECT_NEAR(gain(alias_free_fraction), 1.0, 3e-5);
    for (double fraction = 0.7; fraction < 3.0; fraction += 0.03) {
      EXPECT_LT(gain(fraction), 3e-5) << fraction;
    }
  }
}

// @param least errors count against this acceleration where H is smaller
void expect_recorded_ratio(const SecondOrderSystem& system,
                           double least,
                           double tolerance) {
  const VirtualRecorder recorder{256.0, 16};
  const std::vector<HammerPulse> pulses{{0.5, 0.008, 12.0, 0.93}};
  const Eigen::MatrixXd response =
      simulate_response(system, pulses, 12.0, recorder, {});
  for (const double hz : {1.0, 7.0, 14.7, 23.0, 39.5, 60.0, 70.0}) {
    const Eigen::RowVectorXcd X = transform(response, hz, recorder.rate_hz);
    const Eigen::VectorXcd H = accelerance(system, hz);
    for (int sensor = 0; sensor < 2; ++sensor) {
      EXPECT_LT(std::abs(X(1 + sensor) / X(0) - H(sensor)) /
                    std::max(least, std::abs(H(sensor))),
                tolerance)
          << hz << " Hz, sensor " << sensor;
    }
  }
}

TEST(VirtualTest, RecordedRatioIsTheAccelerance) {
  // Both channels carry the same filter; what is left is its stop band (3e-5)
  // and images of the fast rate.
  expect_recorded_ratio(pair(), 0.0, 5e-5);
}

// What gives at a point hit in its own plane: stiff, with hardly any mass, and
// near the rate of integration.
TEST(VirtualTest, StiffModesDoNotAnswerTheCornersOfTheForce) {
  const SecondOrderSystem soft = pair();
  SecondOrderSystem system;
  system.M = Eigen::MatrixXd::Identity(3, 3);
  system.C = Eigen::MatrixXd::Zero(3, 3);
  system.K = Eigen::MatrixXd::Zero(3, 3);
  system.M.topLeftCorner(2, 2) = soft.M;
  system.C.topLeftCorner(2, 2) = soft.C;
  system.K.topLeftCorner(2, 2) = soft.K;
  const double w = 2.0 * pi * 1.1 * 256.0 * 16.0;
  system.K(2, 2) = w * w;
  system.C(2, 2) = 2.0 * 0.05 * w;
  system.input.resize(3);
  system.input << soft.input, 12.0;
  system.output.resize(2, 3);
  system.output << soft.output, Eigen::Vector2d(8.0, 5.0);
  // Its answer at 1 kHz, 5 m/s^2 per newton, comes through the stop band
  // (3e-5). With a force in straight lines the error would be 4e-2.
  expect_recorded_ratio(system, 0.5, 2e-4);
}

TEST(VirtualTest, DelayMovesAChannel) {
  const VirtualRecorder recorder{256.0, 16};
  const double delay = 0.37 / (256.0 * 16.0);
  const std::vector<HammerPulse> pulses{{0.2, 0.008, 12.0, 1.0}};
  const Eigen::MatrixXd none =
      simulate_response(pair(), pulses, 8.0, recorder, {});
  const Eigen::MatrixXd late =
      simulate_response(pair(), pulses, 8.0, recorder, {0.0, 0.0, delay});
  EXPECT_EQ(none.leftCols(2), late.leftCols(2));
  const Complex ratio =
      transform(late, 11.0, 256.0)(2) / transform(none, 11.0, 256.0)(2);
  // What is still moving at the record's end is cut off: 1e-6 of the start.
  EXPECT_NEAR(std::arg(ratio), -2.0 * pi * 11.0 * delay, 1e-4);
}

TEST(HammerPulse, HitsVaryAndKeepTheirGaps) {
  HammerHand hand;
  hand.hits = 40;
  SeededRandom random(3, "hits");
  const std::vector<HammerPulse> hits = ordinary_hits(hand, random);
  ASSERT_EQ(hits.size(), 40U);
  double low = 1e9;
  double high = 0.0;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    low = std::min(low, hits[k].peak_n);
    high = std::max(high, hits[k].peak_n);
    EXPECT_GE(hits[k].begin_s,
              hand.lead_s + hand.gap_s * static_cast<double>(k));
    EXPECT_LE(hits[k].begin_s + hits[k].width_s,
              hand.lead_s + hand.gap_s * (static_cast<double>(k) + 0.03));
  }
  EXPECT_GT(high / low, 1.5);
}

TEST(HammerPulse, ForceHasTheStatedPeakAndWidth) {
  const HammerPulse pulse{0.1, 0.01, 20.0, 0.9};
  const Eigen::VectorXd force = force_of({pulse}, 4000, 10000.0);
  // 100 samples over the pulse: the peak is met within (pi / 200)^2 / 2.
  EXPECT_NEAR(force.maxCoeff(), 20.0, 0.01);
  EXPECT_EQ(force.head(1000).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(force.tail(2899).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_GE(force.minCoeff(), 0.0);
}

TEST(HammerPulse, ReboundFollowsTheHit) {
  const HammerPulse first{1.0, 0.008, 20.0, 1.0};
  SeededRandom random(5, "rebound");
  const HammerPulse second = rebound(first, random);
  EXPECT_GT(second.begin_s, first.begin_s + first.width_s);
  EXPECT_LT(second.begin_s, first.begin_s + 0.1);
  EXPECT_GT(second.peak_n, 0.2 * first.peak_n);
}

TEST(AnalogueChain, ClipsAndCountsIn24Bits) {
  AnalogueChannel channel;
  channel.full_scale = 10.0;
  SeededRandom random(1, "chain");
  const Eigen::VectorXd signal = Eigen::Vector4d(-25.0, 3.3, 9.99, 12.0);
  const Eigen::VectorXd v = pass_chain(signal, 256.0, channel, random);
  EXPECT_EQ(v(0), -1.0);
  EXPECT_EQ(v(3), 1.0 - 0x1p-23);
  for (const double value : v) {
    EXPECT_EQ(value * 0x1p23, std::round(value * 0x1p23));
  }
  EXPECT_NEAR(v(1), 0.33, 0x1p-24 * 1.0001);
}

TEST(AnalogueChain, AddsEachFaultInItsSize) {
  AnalogueChannel channel;
  channel.noise_rms = 1e-3;
  SeededRandom random(2, "chain");
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(25600);
  const Eigen::VectorXd noise = pass_chain(zero, 256.0, channel, random);
  // Standard error of an rms from 25600 values: 0.44 %; five of them.
  EXPECT_NEAR(std::sqrt(noise.squaredNorm() / 25600.0), 1e-3, 2.2e-5);

  channel = {};
  channel.hum = 1e-3;
  const Eigen::VectorXd hum = pass_chain(zero, 256.0, channel, random);
  const auto line = [&](double hz) {
    return 2.0 / 25600.0 * std::abs(transform(hum, hz, 256.0)(0));
  };
  // The amplitude itself scatters by a factor exp(+-2.5 * 0.3).
  EXPECT_GT(line(50.0), 0.47e-3);
  EXPECT_LT(line(50.0), 2.2e-3);
  EXPECT_GT(line(100.0), 0.1e-3);
  EXPECT_LT(line(106.0), 1e-6) << "150 Hz lies above half the sampling rate";

  channel = {};
  channel.offset = 0.01;
  channel.gain = -1.0;
  const Eigen::VectorXd tilted =
      pass_chain(Eigen::VectorXd::Constant(8, 0.5), 256.0, channel, random);
  EXPECT_LT(tilted(0), -0.47);
}

TEST(VirtualTest, SameSeedSameSamples) {
  const Eigen::MatrixXd response = Eigen::MatrixXd::Random(500, 3);
  AnalogueChannel channel;
  channel.noise_rms = 0.01;
  channel.hum = 0.01;
  channel.drift = 0.01;
  const std::vector<AnalogueChannel> channels(3, channel);
  SeededRandom first(9, "run", 4);
  SeededRandom again(9, "run", 4);
  SeededRandom other(9, "run", 5);
  const Eigen::MatrixXd a = digitise(response, {}, channels, first);
  EXPECT_EQ(a, digitise(response, {}, channels, again));
  EXPECT_NE(a, digitise(response, {}, channels, other));
}

TEST(SeededRandom, FirstNumbersAreFixed) {
  // Golden: a change here changes every recording made before.
  SeededRandom random(7, "golden");
  const double first = random.normal();
  SeededRandom again(7, "golden");
  EXPECT_EQ(first, again.normal());
  double sum = 0.0;
  double squares = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  // Standard errors 0.007 and 0.010; five of them.
  EXPECT_NEAR(sum / 20000.0, 0.0, 0.035);
  EXPECT_NEAR(squares / 20000.0, 1.0, 0.05);
}

TEST(ChooseSensitivity, TakesTheNextRoundStep) {
  EXPECT_DOUBLE_EQ(choose_sensitivity(100.0, 5.0, 1.25), 0.02);
  EXPECT_DOUBLE_EQ(choose_sensitivity(39.0, 5.0, 1.25), 0.1);
  EXPECT_DOUBLE_EQ(choose_sensitivity(70.0, 5.0, 1.25), 0.05);
}

}  // namespace
}  // namespace tapfit::acquisition
