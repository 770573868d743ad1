// Two sensors of one run at one grid and direction: they see one motion, so
// that signals which differ say that a point or a channel is named wrongly.
//
//   r = sum(x y) / sqrt(sum(x^2) sum(y^2))
//
// over the samples where either is above a fifth of its peak, so that noise
// between hits does not count.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"

#include <vector>

namespace tapfit::acquisition {

/// One finding for two channels of one quantity, with all runs in which |r| is
/// below 0.87 (half of one signal is not in the other), r is negative or one is
/// more than twice the other.
///
/// @param recordings of all runs; those without samples are passed over
[[nodiscard]] std::vector<Finding> one_point_findings(
    const TestBundle& bundle, const std::vector<Recording>& recordings);

}  // namespace tapfit::acquisition
