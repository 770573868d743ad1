// The band laid on the unit circle, and sums over its lines by FFT.
//
//   Omega_k = exp(-j theta_k),  theta_k = (omega_k - omega_0) dt
//   y(l) = Re sum_k x_k Omega_k^l
//
// Lines are evenly spaced, so that with dt = 2 pi / (N spacing) the sums for
// all lags l are one FFT of length N: O(N log N) instead of O(lines lags).
#pragma once

#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// How the band lies on the upper half of the unit circle.
struct BandCircle {
  double omega_0 = 0.0;     ///< [rad/s], angle 0
  double dt = 0.0;          ///< [s]
  double first = 0.0;       ///< angle of the first line [rad]
  Eigen::Index length = 0;  ///< N, lines on the whole circle
};

/// Leaves gaps at both ends of the half circle, because poles there have mirror
/// images, but no wider than what powers up to `largest` resolve: in a wider
/// gap polynomials of that degree are free to do anything.
[[nodiscard]] BandCircle lay_on_circle(const WeightedFrfs& curves,
                                       Eigen::Index largest);

/// y(l) for l = -largest .. largest in rows, per column of x.
///
/// @param x n_lines x m
/// @return (2 largest + 1) x m
[[nodiscard]] Eigen::MatrixXd lag_sums(const BandCircle& circle,
                                       const Eigen::MatrixXcd& x,
                                       Eigen::Index largest);

}  // namespace tapfit::modal
