// How far the truth may be from an estimated FRF, where the variance itself is
// an estimate of n degrees of freedom:
//
//   |dH|^2 <= (n / 2) (q^(-2/n) - 1) E|dH|^2
//   |Re dH|, |Im dH|, |d|H||  <= t_n(0.975) sqrt(E|dH|^2 / 2)
//
// the first around H in all but a share q of cases, the second in 95 %
// (an F and a t quantile: circular noise over a chi-squared one). The
// magnitude's band is to first order in dH.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

namespace tapfit::signal {

/// Radius of the circle around H per line [(m/s^2)/N].
///
/// @param outside q, how often the truth may lie outside of it
[[nodiscard]] Eigen::VectorXd confidence_radius(const Frf& frf,
                                                double outside = 0.05);

/// Half width of the band of the real part, the imaginary part or the
/// magnitude, per line [(m/s^2)/N].
[[nodiscard]] Eigen::VectorXd confidence_reach(const Frf& frf);

}  // namespace tapfit::signal
