// A recorder's filter that rings after a pulse only.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <numbers>

namespace tapfit::testing {

/// Behind a causal Butterworth filter of order 8 at 0.4 of the recorder's rate
/// (bilinear transform, four sections). A pulse's first lobes are 30 and 17 %.
///
/// @param x at `over` times the rate, which it keeps
inline Eigen::VectorXd behind_butterworth(Eigen::VectorXd x, int over) {
  const double pi = std::numbers::pi;
  const double K = std::tan(pi * 0.4 / over);
  for (int section = 0; section < 4; ++section) {
    const double damping = 2.0 * std::sin(pi * (2 * section + 1) / 16.0);
    const double norm = 1.0 / (1.0 + K * damping + K * K);
    const double a1 = 2.0 * (K * K - 1.0) * norm;
    const double a2 = (1.0 - K * damping + K * K) * norm;
    const double b = K * K * norm;
    double z1 = 0.0;
    double z2 = 0.0;
    for (double& value : x) {
      const double y = b * value + z1;
      z1 = 2.0 * b * value - a1 * y + z2;
      z2 = b * value - a2 * y;
      value = y;
    }
  }
  return x;
}

}  // namespace tapfit::testing
