// Blows that follow (or precede) a hit's main pulse within its block.
#pragma once

#include "acquisition/hits/hammer_pulses.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::acquisition {

/// The other pulses of a block, in time order.
///
/// Each reaches `least_share` of the main pulse, stands 6.5 times out of the
/// noise and clearly out of what swings below zero around it: the ringing of an
/// anti-alias filter, hum and vibration are as large below zero as above, a
/// blow is not.
///
/// @param hammer force drift-free, blows positive [N]
/// @param begin, end samples of the block
/// @param least_share of the main pulse's height; met to a tenth, since the
///   height of a pulse a few samples wide is known no better
[[nodiscard]] std::vector<Pulse> second_pulses(const HammerSignal& hammer,
                                               const Pulse& main,
                                               Eigen::Index begin,
                                               Eigen::Index end,
                                               double least_share);

}  // namespace tapfit::acquisition
