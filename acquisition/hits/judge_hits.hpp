// What speaks against a hit, one question each.
#pragma once

#include "acquisition/hits/hammer_pulses.hpp"

#include <Eigen/Core>

namespace tapfit::acquisition {

/// Where the main pulse's force spectrum has first fallen below its low end by
/// so many decibels [Hz], to 1 in 1000 of what a pulse as wide reaches. What
/// lobes of the spectrum bring behind that does not count: lines before them,
/// at its zeros, are without force.
///
/// @param fallen_db below 0
/// @param most_hz the answer where it does not fall as far up to there
[[nodiscard]] double force_reach_hz(const HammerSignal& hammer,
                                    const Pulse& main,
                                    double fallen_db,
                                    double most_hz,
                                    double sample_rate_hz);

/// Sample-to-sample noise of a channel: robust standard deviation of its first
/// differences over sqrt(2), from the quietest of 16 parts (of 4096 to 8191
/// pairs of neighbours of each).
[[nodiscard]] double difference_noise(
    const Eigen::Ref<const Eigen::VectorXd>& channel);

}  // namespace tapfit::acquisition
