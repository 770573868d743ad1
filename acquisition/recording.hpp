// One recording in physical units.
#pragma once

#include "acquisition/test_bundle.hpp"

#include <Eigen/Core>

namespace tapfit::acquisition {

struct Recording {
  double sample_rate_hz = 0.0;
  Eigen::MatrixXd samples;  ///< n_samples x n_channels [SI]: N, m/s^2
};

/// Reads one run's file with libsndfile and scales every channel to SI.
///
/// @throws InputError for a missing or unreadable file, a channel count that
///   differs from the bundle's, a sample that is not finite (with its time
///   and channel)
[[nodiscard]] Recording read_recording(const TestBundle& bundle,
                                       const Run& run);

/// All runs of the bundle, in order; they must agree in sampling rate.
[[nodiscard]] std::vector<Recording> read_recordings(const TestBundle& bundle);

}  // namespace tapfit::acquisition
