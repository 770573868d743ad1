// One recording in physical units.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <Eigen/Core>

namespace tapfit::acquisition {

struct Recording {
  double sample_rate_hz = 0.0;
  Eigen::MatrixXd samples;  ///< n_samples x n_channels [SI]: N, m/s^2
};

/// What read_recording() asks of samples, for those that read otherwise.
///
/// @param first sample of the piece, from the file's start
/// @throws InputError with channel and time for a sample that is not finite
void check_finite(const Eigen::Ref<const Eigen::MatrixXd>& samples,
                  Eigen::Index first,
                  double rate,
                  const TestBundle& bundle,
                  const std::string& file);
/// Per channel what a sample of 1.0 is [SI].
[[nodiscard]] Eigen::RowVectorXd full_scales(const TestBundle& bundle);
/// @throws InputError unless the file has as many channels as the bundle
void check_channels(const TestBundle& bundle,
                    const Run& run,
                    Eigen::Index channels);
/// @throws InputError when the band reaches half the sampling rate
void check_band(const TestBundle& bundle, double rate, const std::string& file);

}  // namespace tapfit::acquisition
