// What of the recording or of test.json ought to be set right, since it
// falsifies hits and the FRFs made of them.
#pragma once

#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hit_steps.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Blows that go the wrong way, a trigger on the side that blows do not go to,
/// a pre-trigger within the blow's rise, a block that holds the next blow too,
/// and pulses too short for the sampling rate.
///
/// @param runs with their pulses
/// @param options as completed by the bundle's
/// @param set with rate, block and pre-trigger
[[nodiscard]] std::vector<Finding> hit_warnings(
    const TestBundle& bundle,
    const std::vector<HammerRun>& runs,
    const HitOptions& options,
    const HitSet& set);

}  // namespace tapfit::acquisition
