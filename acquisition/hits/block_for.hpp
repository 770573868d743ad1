// The block that the responses of a test need: how long they last, and what the
// band asks for.
#pragma once

#include "acquisition/hits/choose_block.hpp"
#include "acquisition/hits/hit_steps.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Looks at all sensors' responses to the clearest hit of each run.
///
/// @param runs one per recording, with their pulses grouped
[[nodiscard]] Block block_for(const TestBundle& bundle,
                              const std::vector<Recording>& recordings,
                              const std::vector<HammerRun>& runs,
                              const HitOptions& options);

}  // namespace tapfit::acquisition
