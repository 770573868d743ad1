// Records for rates of false alarms and of detections: a blow, maybe a second
// one, in noise; decays, maybe clipped. For tests and the study over seeds.
#pragma once

#include "acquisition/judge_hits.hpp"
#include "tests/acquisition/hammer_record.hpp"

namespace tapfit::testing {

using acquisition::HammerSignal;
using Eigen::Index;

struct Setting {
  double rate = 0.0;
  double width_s = 0.0;
  double block_s = 0.0;
};

// As wide as a pulse looks after the filter: its own width, two samples more.
inline double seen_width(const Setting& s) { return s.width_s + 2.0 / s.rate; }

inline HammerSignal make(const Setting& s,
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
  return acquisition::prepare_hammer(force, s.rate);
}

inline bool judged_double(const HammerSignal& hammer) {
  Index peak = 0;
  hammer.force.maxCoeff(&peak);
  return acquisition::has_second_pulse(
      hammer,
      acquisition::measure_pulse(hammer.force, peak),
      0,
      hammer.force.size(),
      5.0);
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

}  // namespace tapfit::testing
