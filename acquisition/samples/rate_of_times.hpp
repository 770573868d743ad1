// The sampling rate behind a list of sample times.
//
//   rate = (n - 1) / (t_n - t_1)
//
// Times printed with few digits lie beside the straight line through the ends
// by up to d; so may the ends, and the rate is known to 2 d / (t_n - t_1).
#pragma once

#include <Eigen/Core>

#include <optional>

namespace tapfit::acquisition {

struct RateOfTimes {
  double hz = 0.0;
  double spread = 0.0;  ///< how far it may be off, relative to it
  /// The first time that is half a step or more from where it should be.
  std::optional<Eigen::Index> uneven;
};

/// @param time of each sample [s]
/// @return empty when the times do not rise
[[nodiscard]] std::optional<RateOfTimes> rate_of_times(
    const Eigen::VectorXd& time);

}  // namespace tapfit::acquisition
