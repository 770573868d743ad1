// The low-pass filter of a recorder and the fall to its sampling rate.
//
// A linear-phase FIR filter (windowed sinc, Kaiser window), the same for every
// channel, its delay taken out, so that it cancels in every ratio of channels.
// The transition is wide (0.3 to 0.7 of the sampling rate): a steep filter
// would ring on a hammer pulse that is only a few samples long. What aliases
// therefore falls above 0.3 of the sampling rate, outside the band in use.
//
// Source: A. V. Oppenheim and R. W. Schafer, "Discrete-Time Signal
// Processing", 3rd ed., 2010, sec. 7.5.3.
#pragma once

#include <Eigen/Core>

namespace tapfit::acquisition {

/// Highest frequency without aliases, of the recorder's sampling rate.
inline constexpr double alias_free_fraction = 0.3;

/// Filter taps at the fast rate: odd count, symmetric, sum 1.
///
/// @param oversampling fast rate over recorder's rate, at least 2
[[nodiscard]] Eigen::VectorXd anti_alias_taps(int oversampling);

/// Filters and keeps every oversampling-th sample.
///
/// @param fast n x channels at the fast rate, zero outside
/// @return ceil(n / oversampling) x channels; sample m belongs to the time of
///   fast sample m * oversampling
[[nodiscard]] Eigen::MatrixXd decimate(
    const Eigen::Ref<const Eigen::MatrixXd>& fast, int oversampling);

}  // namespace tapfit::acquisition
