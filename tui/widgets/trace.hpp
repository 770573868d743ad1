// A recording small enough to be drawn at any zoom: the lowest and highest
// sample of every stretch of samples.
#pragma once

#include "acquisition/bundle/recording.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::tui {

struct Trace {
  double sample_rate_hz = 0.0;
  Eigen::Index samples = 0;
  Eigen::Index stretch = 1;  ///< samples behind each row
  Eigen::MatrixXf low;       ///< n_stretches x n_channels [SI]
  Eigen::MatrixXf high;

  [[nodiscard]] double duration_s() const {
    return sample_rate_hz > 0.0 ? static_cast<double>(samples) / sample_rate_hz
                                : 0.0;
  }
};

/// Recordings of up to `most` samples keep each sample; longer ones are
/// thinned to at most that many stretches, no extreme is lost.
[[nodiscard]] Trace trace(const acquisition::Recording& recording,
                          Eigen::Index most = 200000);

/// One channel between two times, as at most `columns` lowest and highest.
struct Envelope {
  Eigen::VectorXd time_s;
  Eigen::VectorXd low;
  Eigen::VectorXd high;
};
[[nodiscard]] Envelope envelope(const Trace& trace,
                                Eigen::Index channel,
                                double from_s,
                                double to_s,
                                Eigen::Index columns);

}  // namespace tapfit::tui
