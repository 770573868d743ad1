// Why runs have no hit that counts, hit by hit, and the shortest way out.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/hits.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Runs of which every hit was judged out, one finding for those of the same
/// reasons: how many hits for which, clipped channels by name. Errors where no
/// run has an accepted hit, else warnings.
///
/// @param recordings of all runs; those without samples are passed over
[[nodiscard]] std::vector<Finding> rejected_hit_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

/// That no hit counts, run by run, with the shortest way out.
///
/// @return "no run has an accepted hit: run 1: ..." as an error to be thrown
[[nodiscard]] InputError no_accepted_hit(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

/// Channels that are clipped in half of the hits or more of all runs.
[[nodiscard]] std::vector<Finding> clipping_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

/// A trigger that lies within the hammer's noise.
[[nodiscard]] std::vector<Finding> trigger_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

}  // namespace tapfit::acquisition
