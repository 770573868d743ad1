// Values of a sampled signal between its samples.
//
//   x(t) = sum_n x[n] sinc(t - n) w(t - n)
//
// with a Hann window w over 16 samples to either side. Right for signals that
// an anti-alias filter has limited to about 0.45 of the sampling rate, where a
// pulse may be two samples wide and its peak lie between them.
// Source: Oppenheim and Schafer, Discrete-Time Signal Processing, sec. 4.2.
#pragma once

#include <Eigen/Core>

namespace tapfit::acquisition {

/// @param position in samples; the signal is zero beyond its ends
[[nodiscard]] double interpolate(const Eigen::VectorXd& signal,
                                 double position);

/// The same at `steps` even places per sample, from one sample to another; as
/// many sines as one sample's places need.
///
/// @return (last - first) * steps + 1 values
[[nodiscard]] Eigen::VectorXd interpolated(const Eigen::VectorXd& signal,
                                           Eigen::Index first,
                                           Eigen::Index last,
                                           Eigen::Index steps);

struct Peak {
  double position = 0.0;  ///< [samples]
  double height = 0.0;
};

/// The maximum within one sample of the given sample, to 1/16 of a sample and
/// a parabola through the three best points.
[[nodiscard]] Peak interpolated_peak(const Eigen::VectorXd& signal,
                                     Eigen::Index sample);

}  // namespace tapfit::acquisition
