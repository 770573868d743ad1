// Records for rates of false alarms and of detections: a blow, maybe a second
// one, in noise; decays, maybe clipped. For tests and the study over seeds.
#pragma once

#include "acquisition/hits/judge_hits.hpp"
#include "acquisition/hits/overload.hpp"
#include "acquisition/hits/second_pulses.hpp"
#include "tests/acquisition/support/hammer_record.hpp"

namespace tapfit::testing {

using Eigen::Index;

struct Setting {
  double rate = 0.0;
  double width_s = 0.0;
  double block_s = 0.0;
};

// As wide as a pulse looks after the filter: its own width, two samples more.
inline double seen_width(const Setting& s) { return s.width_s + 2.0 / s.rate; }

inline Eigen::VectorXd make(const Setting& s,
                            double second_share,
                            double noise_share,
                            std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto n = static_cast<Index>(s.block_s * s.rate);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
  const bool filter = s.width_s * s.rate < 20.0;
  const double at = 0.1 * s.block_s + uniform(random) / s.rate;
  const double peak = 20.0;
  add_pulse(force, s.rate, at, s.width_s, peak, filter);
  if (second_share > 0.0) {
    const double nearest = 3.0 * seen_width(s);
    const double farthest = std::max(nearest, 0.8 * s.block_s);
    // Most bounces come soon: spread evenly in the logarithm.
    const double after =
        nearest * std::pow(farthest / nearest, uniform(random));
    add_pulse(
        force, s.rate, at + after, s.width_s, second_share * peak, filter);
  }
  const double top = force.maxCoeff();
  add_noise(force, noise_share * top, random);
  return force;
}

inline bool judged_double(const Eigen::VectorXd& force, double rate) {
  const auto hammer = acquisition::prepare_hammer(force, rate);
  Index peak = 0;
  force.maxCoeff(&peak);
  const acquisition::Pulse main =
      acquisition::measure_pulse(hammer.force, peak);
  return !acquisition::second_pulses(hammer, main, 0, hammer.force.size(), 0.05)
              .empty();
}

struct Rate {
  int yes = 0;
  int all = 0;
  [[nodiscard]] double percent() const { return 100.0 * yes / all; }
};

// A decaying oscillation, quantised to 16 bits of a full scale of 1.
inline Eigen::VectorXd decay16(double frequency, double level, double clip) {
  Eigen::VectorXd x(20000);
  for (Index i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) / 5000.0;
    const double value = level * std::exp(-0.3 * t) *
                         std::sin(2.0 * std::numbers::pi * frequency * t);
    x[i] = std::round(std::clamp(value, -clip, clip) * 32768.0) / 32768.0;
  }
  return x;
}

inline double between(double low, double high, std::mt19937_64& random) {
  return low *
         std::pow(high / low, std::uniform_real_distribution<double>()(random));
}

// Two to five modes of any frequency, phase and decay; largest value 1.
inline Eigen::VectorXd ringing_modes(std::mt19937_64& random) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(20000);
  const int modes = std::uniform_int_distribution<int>(2, 5)(random);
  for (int m = 0; m < modes; ++m) {
    const double w = 2.0 * std::numbers::pi * between(1.0, 1000.0, random);
    const double decay = between(0.02, 50.0, random);
    const double gain = between(0.1, 1.0, random);
    const double phase =
        std::uniform_real_distribution<double>(0.0, 6.3)(random);
    for (Index i = 0; i < x.size(); ++i) {
      const double t = static_cast<double>(i) / 5000.0;
      x[i] += gain * std::exp(-decay * t) * std::sin(w * t + phase);
    }
  }
  return x / x.cwiseAbs().maxCoeff();
}

// A blow of 3 to 400 samples: cos^p, p from 1/2 to 3 (a spring gives 1, Hertz's
// contact some 1.5), its top lifted or dented by up to 0.2; largest value 1.
inline Eigen::VectorXd any_pulse(std::mt19937_64& random) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(5000);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double width = between(3.0, 400.0, random);
  const double power = between(0.5, 3.0, random);
  const double middle = 2000.0 + uniform(random);
  const double dent = 0.4 * uniform(random) - 0.2;
  for (Index i = 0; i < x.size(); ++i) {
    const double t =
        std::numbers::pi * (static_cast<double>(i) - middle) / width;
    if (std::abs(t) >= 0.5 * std::numbers::pi) continue;
    x[i] = std::pow(std::cos(t), power) * (1.0 + dent * std::cos(3.0 * t));
  }
  return x / x.maxCoeff();
}

// A record as it comes out of a converter that clips, with noise that follows
// it: half a second of quiet, then the signal, in 24 bits.
inline Eigen::VectorXd converted(const Eigen::VectorXd& signal,
                                 double ceiling,
                                 double noise,
                                 std::mt19937_64& random) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(signal.size() + 2500);
  x.tail(signal.size()) = signal.cwiseMin(ceiling).cwiseMax(-ceiling);
  add_noise(x, noise, random);
  for (double& value : x) value = std::round(value * 0x1p23) * 0x1p-23;
  return x;
}

// Whether it is called overdriven, its noise known as hits' noise is.
inline bool judged_overload(const Eigen::VectorXd& x) {
  return acquisition::is_overloaded(x, 1.0, acquisition::difference_noise(x));
}

}  // namespace tapfit::testing
