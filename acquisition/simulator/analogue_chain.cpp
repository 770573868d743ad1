#include "acquisition/simulator/analogue_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::acquisition {
namespace {

void add_hum(Eigen::VectorXd& v,
             double rate_hz,
             double amplitude,
             SeededRandom& random) {
  for (int order = 1; order * mains_hz < rate_hz / 2.0; ++order) {
    const double size = amplitude / (order * order) * random.scatter(0.3);
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double step = 2.0 * std::numbers::pi * order * mains_hz / rate_hz;
    for (Eigen::Index n = 0; n < v.size(); ++n) {
      v(n) += size * std::sin(step * static_cast<double>(n) + phase);
    }
  }
}

// Slow waves of about one and a few minutes: warm-up, draught.
void add_drift(Eigen::VectorXd& v,
               double rate_hz,
               double size,
               SeededRandom& random) {
  for (const double period_s : {75.0, 190.0}) {
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double amplitude = 0.5 * size * random.scatter(0.3);
    const double step = 2.0 * std::numbers::pi / (period_s * rate_hz);
    for (Eigen::Index n = 0; n < v.size(); ++n) {
      v(n) += amplitude * std::sin(step * static_cast<double>(n) + phase);
    }
  }
}

}  // namespace

Eigen::VectorXd pass_chain(const Eigen::VectorXd& signal,
                           double rate_hz,
                           const AnalogueChannel& channel,
                           SeededRandom& random) {
  Eigen::VectorXd v = channel.gain * signal;
  for (double& value : v) value += channel.noise_rms * random.normal();
  add_hum(v, rate_hz, channel.hum, random);
  add_drift(v, rate_hz, channel.drift, random);
  v.array() += channel.offset * random.scatter(0.3);
  for (double& value : v) {
    const double steps = std::round(value / channel.full_scale * 0x1p23);
    value = std::clamp(steps, -0x1p23, 0x1p23 - 1.0) * 0x1p-23;
  }
  return v;
}

}  // namespace tapfit::acquisition
