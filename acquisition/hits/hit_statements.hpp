// What was chosen to find and cut the hits, and what is odd about it, in words.
#pragma once

#include "acquisition/hits/hit_steps.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Adds to the set's statements and warnings.
///
/// @param runs with levels and pulses
/// @param options as completed by the bundle's
/// @param set with rate, block, hold-off and reach
void state_choices(const TestBundle& bundle,
                   const std::vector<HammerRun>& runs,
                   const HitOptions& options,
                   HitSet& set);

}  // namespace tapfit::acquisition
