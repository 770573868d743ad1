// What still rings from an earlier hit when the next one comes.
//
//   x(t) = c + sum_r Re(a_r exp(lambda_r t)),   t <= 0 before the hit
//
// with known poles lambda_r is linear in a_r and c: fitted by least squares
// before the hit, continued through its block and subtracted. A lightly damped
// low mode decays for minutes; waiting for it is not always possible, and what
// is left of it is neither noise nor response to the hit.
#pragma once

#include "signal/spectra/offset.hpp"

#include <Eigen/Core>

namespace tapfit::signal {

/// Longest stretch worth fitting: the poles' amplitudes are found from it.
///
/// @param poles [rad/s], Re < 0, Im > 0; may be empty
/// @param fs sampling rate [Hz]
/// @param before samples between the earlier hit and this one
/// @return the part of `before` to fit; empty where it is too short
[[nodiscard]] Stretch carry_over_stretch(const Eigen::VectorXcd& poles,
                                         double fs,
                                         const Stretch& before);

/// The ringing, without c, at samples [begin, begin + n) of a channel.
///
/// @param channel all samples
/// @param fit samples before the hit; an empty stretch gives zeros
/// @param begin first sample wanted; may be negative
[[nodiscard]] Eigen::VectorXd carry_over(
    const Eigen::Ref<const Eigen::VectorXd>& channel,
    const Stretch& fit,
    const Eigen::VectorXcd& poles,
    double fs,
    Eigen::Index begin,
    Eigen::Index n);

}  // namespace tapfit::signal
