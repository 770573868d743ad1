// Modes near 50 Hz, much nearer to each other than their bandwidths.
#pragma once

#include "tests/modal/support/synthetic_frfs.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace tapfit::test {

/// Each mode the given share above the one before, damping ratio 0.008, at 16
/// points; alone between 30 and 70 Hz. No distance makes them one pole.
inline SyntheticSystem close_modes(Eigen::Index count,
                                   double apart,
                                   std::mt19937_64& random) {
  SyntheticSystem system;
  system.frequency_hz.resize(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    system.frequency_hz(r) = 50.0 * std::pow(1.0 + apart, r);
  }
  system.damping_ratio = Eigen::VectorXd::Constant(count, 0.008);
  // Each reference moves most in a mode of its own.
  system.phi = random_shapes(16, count, random);
  system.phi.topRows(count) =
      Eigen::MatrixXd::Identity(count, count).array() + 0.2;
  return system;
}

inline signal::FrfSet close_modes_frfs(const SyntheticSystem& system,
                                       const std::vector<Eigen::Index>& sensors,
                                       double noise,
                                       std::mt19937_64& random) {
  return roving_hammer(
      system, sensors, line_points(30, 70, 400, 0.0), noise, random);
}

}  // namespace tapfit::test
