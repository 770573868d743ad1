#include "signal/line_noise.hpp"

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

LineNoise line_noise(const Eigen::VectorXcd& s,
                     const HitBlocks& blocks,
                     std::size_t sensor) {
  const double fs = 1.0 / blocks.dt;
  LineNoise noise{Eigen::VectorXd(s.size()),
                  Eigen::VectorXd(s.size()),
                  Eigen::VectorXd(s.size())};
  WindowSums response;
  WindowSums force;
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    // Lines mostly share their decay rate.
    if (i == 0 || s(i).real() != s(i - 1).real()) {
      response = sums_of(
          blocks.response_power, blocks.trigger, blocks.dt, s(i).real());
      force =
          sums_of(blocks.force_power, blocks.trigger, blocks.dt, s(i).real());
    }
    const double omega = s(i).imag();
    noise.response(i) = blocks.noise[sensor].at(omega) * response.w2;
    noise.force(i) = blocks.force_noise.at(omega) * force.w2;
    noise.bandwidth(i) =
        2.0 * std::numbers::pi * fs * response.w4 / (response.w2 * response.w2);
  }
  return noise;
}

}  // namespace tapfit::signal
