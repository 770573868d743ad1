// Recordings of hammer blows made for tests: half-sine pulses, optionally
// through a linear-phase anti-alias filter, and a decaying response.
#pragma once

#include "acquisition/hits/hits.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::testing {

/// Adds a half-sine pulse of given peak and base width, centred at `time_s`;
/// another power than 1 gives cos^power, 2 the shape of Hann's window.
///
/// With the filter, each sample is the pulse convolved with a Hann-windowed
/// sinc that cuts at 0.42 of the sampling rate (24 samples to either side),
/// integrated on a grid of at least 64 points over the pulse.
inline void add_pulse(Eigen::VectorXd& force,
                      double rate,
                      double time_s,
                      double width_s,
                      double peak,
                      bool filter,
                      double power = 1.0) {
  const double pi = std::numbers::pi;
  const double half = 24.0;
  const auto shape = [&](double t) {
    if (std::abs(t) >= 0.5 * width_s) return 0.0;
    const double cosine = std::cos(pi * t / width_s);
    return power == 1.0 ? cosine : std::pow(cosine, power);
  };
  const double reach = 0.5 * width_s * rate + half + 1.0;
  const auto centre = static_cast<Eigen::Index>(std::llround(time_s * rate));
  const auto span = static_cast<Eigen::Index>(std::ceil(reach));
  const auto points = std::max<Eigen::Index>(
      64, static_cast<Eigen::Index>(8.0 * width_s * rate));
  for (Eigen::Index i = std::max<Eigen::Index>(0, centre - span);
       i <= std::min(force.size() - 1, centre + span);
       ++i) {
    const double t = static_cast<double>(i) / rate - time_s;
    if (!filter) {
      force[i] += peak * shape(t);
      continue;
    }
    double sum = 0.0;
    for (Eigen::Index k = 0; k < points; ++k) {
      const double u =
          ((static_cast<double>(k) + 0.5) / static_cast<double>(points) - 0.5) *
          width_s;
      const double x = (t - u) * rate;
      if (std::abs(x) >= half) continue;
      const double argument = 0.84 * pi * x;
      const double sinc =
          std::abs(argument) < 1e-9 ? 1.0 : std::sin(argument) / argument;
      sum += shape(u) * sinc * 0.84 * (0.5 + 0.5 * std::cos(pi * x / half));
    }
    force[i] += peak * sum * width_s * rate / static_cast<double>(points);
  }
}

inline void add_noise(Eigen::VectorXd& channel,
                      double sd,
                      std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (double& value : channel) value += sd * normal(random);
}

/// Adds amplitude * exp(-decay (t - t0)) sin(2 pi f (t - t0)) from t0 on.
inline void add_response(Eigen::VectorXd& channel,
                         double rate,
                         double start_s,
                         double frequency_hz,
                         double decay,
                         double amplitude) {
  for (Eigen::Index i = 0; i < channel.size(); ++i) {
    const double t = static_cast<double>(i) / rate - start_s;
    if (t < 0.0) continue;
    channel[i] += amplitude * std::exp(-decay * t) *
                  std::sin(2.0 * std::numbers::pi * frequency_hz * t);
  }
}

/// A bundle of a hammer and one accelerometer, and no files behind it.
/// Full scales are 500 N and 500 m/s^2.
inline acquisition::TestBundle hammer_bundle(std::size_t runs = 1) {
  acquisition::TestBundle bundle;
  acquisition::Channel hammer;
  hammer.name = "hammer";
  hammer.quantity = acquisition::Quantity::Force;
  hammer.unit = "N";
  hammer.full_scale_volts = 500.0;
  acquisition::Channel sensor = hammer;
  sensor.name = "acc1";
  sensor.quantity = acquisition::Quantity::Acceleration;
  sensor.unit = "m/s^2";
  bundle.channels = {hammer, sensor};
  for (std::size_t r = 0; r < runs; ++r) {
    acquisition::Run run;
    run.file = "run-" + std::to_string(r + 1) + ".wav";
    run.hammer = {0, Dof{1, 3, 1}};
    run.sensors = {{1, Dof{2, 3, 1}}};
    bundle.runs.push_back(run);
  }
  return bundle;
}

}  // namespace tapfit::testing
