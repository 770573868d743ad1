#include "signal/spectra/line_noise.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::signal {
namespace {

struct WindowSums {
  double w2 = 0.0;
  double w4 = 0.0;
};

// Sums over the squared window w2 under exp(-2 sigma t), t = 0 at the trigger.
WindowSums sums_of(const Eigen::VectorXd& w2,
                   Eigen::Index trigger,
                   double dt,
                   double sigma) {
  WindowSums sums;
  const double step = std::exp(-2.0 * sigma * dt);
  double decay = std::exp(2.0 * sigma * dt * static_cast<double>(trigger));
  for (Eigen::Index i = 0; i < w2.size(); ++i) {
    const double value = w2(i) * decay;
    sums.w2 += value;
    sums.w4 += value * value;
    decay *= step;
    if (decay < 1e-12) break;
  }
  return sums;
}

}  // namespace

std::vector<LineNoise> line_noise(const Eigen::VectorXcd& s,
                                  const HitBlocks& blocks) {
  const double fs = 1.0 / blocks.dt;
  const Eigen::Index lines = s.size();
  std::vector<LineNoise> noise(blocks.responses.size());
  for (LineNoise& of : noise) {
    of.response.resize(lines);
    of.force.resize(lines);
    of.bandwidth.resize(lines);
  }
  WindowSums response;
  WindowSums force;
  for (Eigen::Index i = 0; i < lines; ++i) {
    // Lines mostly share their decay rate.
    if (i == 0 || s(i).real() != s(i - 1).real()) {
      response = sums_of(
          blocks.response_power, blocks.trigger, blocks.dt, s(i).real());
      force =
          sums_of(blocks.force_power, blocks.trigger, blocks.dt, s(i).real());
    }
    const double omega = s(i).imag();
    const double of_force = blocks.force_noise.at(omega) * force.w2;
    const double bandwidth =
        2.0 * std::numbers::pi * fs * response.w4 / (response.w2 * response.w2);
    for (std::size_t c = 0; c < noise.size(); ++c) {
      noise[c].response(i) = blocks.noise[c].at(omega) * response.w2;
      noise[c].force(i) = of_force;
      noise[c].bandwidth(i) = bandwidth;
    }
  }
  return noise;
}

}  // namespace tapfit::signal
