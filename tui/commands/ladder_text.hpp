// The error ladder: how far each added effect brought the error down.
#pragma once

#include "updating/diagnosis.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// One rung per line with a bar, the base first and the floor last:
///
///   base                            38.8 %  ##############################
///   + added-mass at node 201         3.8 %  ###
///   floor                            3.1 %  ##
///
/// @param rungs added effects in order, without the base
[[nodiscard]] std::string ladder_text(double base,
                                      const std::vector<updating::Rung>& rungs,
                                      double floor);

}  // namespace tapfit::tui
