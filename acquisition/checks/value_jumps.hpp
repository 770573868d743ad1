// Jumps within a response: samples that were lost inside a record, so that its
// parts do not fit together, or a blow that was not the hammer's.
//
// Between blows a response is a sum of decays, and hum is one that does not
// decay: each sample follows from those behind it,
//
//   x_n = c + sum_k a_k x_(n+k) + e_n,   k = 1 ... order,
//
// but for noise, with the same a_k behind every blow of a run, since the
// structure is the same: those that are held against one stretch are fitted to
// the others. Where parts were joined that do not belong together e_n stands
// out of the e_n behind it, which know nothing of the jump, and before it. In
// all sensors at once it is no spike of a single cable. Backwards, because that
// works from the blow on, where a response is loud.
//
// Source: linear prediction, as for clicks in S. J. Godsill, P. J. W. Rayner,
// "Digital Audio Restoration", Springer, 1998, ch. 5.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hits.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::acquisition {

struct JumpLimits {
  /// Of the prediction: a dozen modes or tones, with noise on them.
  Eigen::Index order = 40;
  /// |e_n| over its rms on either side, in every sensor; normal noise reaches 5
  /// in a million samples, in one sensor.
  double least_together = 10.0;
  double least_alone = 25.0;  ///< where there is one sensor only
};

/// Samples at which all responses of a run jump while the hammer is at rest,
/// one for each jump.
///
/// @param hits of the run; stretches between them are looked at
[[nodiscard]] std::vector<Eigen::Index> value_jumps(
    const Run& run,
    const Recording& recording,
    const std::vector<Hit>& hits,
    const JumpLimits& limits = {});

/// One finding for all runs that have any.
[[nodiscard]] std::vector<Finding> jump_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

}  // namespace tapfit::acquisition
