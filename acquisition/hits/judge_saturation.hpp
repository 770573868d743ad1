// Blows that the hammer's conditioner has cut off: judged out, or told of.
#pragma once

#include "acquisition/hits/hit_steps.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Whether a hit's main pulse says how high its channel goes: that of a double
/// or weak one does not.
[[nodiscard]] bool tells_height(const Hit& hit);

/// Looks for a ceiling among the hits of each hammer channel, of all runs
/// together, and says so in the set's statements and warnings.
///
/// Where there is more than suspicion, hits that are cut off at it, flatter
/// than others of their points where there are two or more below, are judged
/// overloads; but none of a placement of which fewer than two good ones would
/// remain. Those, and all where it is only suspected, are kept. Double and weak
/// hits say nothing here.
///
/// @param runs with their groups
/// @param set with hits that are judged alone and for weakness; its ceilings
///   are set
void judge_saturation(const TestBundle& bundle,
                      const std::vector<HammerRun>& runs,
                      HitSet& set);

}  // namespace tapfit::acquisition
