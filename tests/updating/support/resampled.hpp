// Signals read off at other times.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace tapfit::updating::testing {

/// Row i of the result is x at row first + i step, between rows by cubic
/// Lagrange polynomials (the signals are smooth); zero outside.
inline Eigen::MatrixXd resampled(const Eigen::MatrixXd& x,
                                 double first,
                                 double step) {
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(x.rows(), x.cols());
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const double at = first + static_cast<double>(i) * step;
    const auto k = static_cast<Eigen::Index>(std::floor(at));
    if (k < 1 || k + 2 >= x.rows()) continue;
    // Nodes -1, 0, 1, 2 around the place t between 0 and 1.
    const double t = at - static_cast<double>(k);
    y.row(i) = -t * (t - 1.0) * (t - 2.0) / 6.0 * x.row(k - 1) +
               (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 * x.row(k) -
               (t + 1.0) * t * (t - 2.0) / 2.0 * x.row(k + 1) +
               (t + 1.0) * t * (t - 1.0) / 6.0 * x.row(k + 2);
  }
  return y;
}

}  // namespace tapfit::updating::testing
