// Free decays with known poles, sampled: what ringing is fitted with.
#pragma once

#include <Eigen/Core>

namespace tapfit::signal {

/// Columns Re and Im of exp(lambda_r t) in turns, 2 per pole.
///
/// @param poles [rad/s], Re < 0
/// @param fs sampling rate [Hz]
/// @param begin first sample, n samples from there
/// @param origin sample at which t = 0
/// @return n x 2 poles
[[nodiscard]] Eigen::MatrixXd decays(const Eigen::VectorXcd& poles,
                                     double fs,
                                     Eigen::Index begin,
                                     Eigen::Index n,
                                     Eigen::Index origin);

/// Amplitudes a_r of x(t) = c + sum_r Re(a_r exp(lambda_r t)) by least squares,
/// the offset c left free.
///
/// Fast poles have vanished at the end of a stretch and are huge at its start;
/// columns of equal length keep the fit well posed.
///
/// @param decays as of decays(), more rows than columns
/// @param x rows as of `decays`, a column per fit
/// @return 2 poles x columns of x: Re(a_r) and -Im(a_r) in turns
[[nodiscard]] Eigen::MatrixXd fit_decays(
    const Eigen::MatrixXd& decays, const Eigen::Ref<const Eigen::MatrixXd>& x);

}  // namespace tapfit::signal
