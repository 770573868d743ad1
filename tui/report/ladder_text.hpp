// The error ladder: how far each added effect brought the error down.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// One rung per line with a bar, the base first and the floor last:
///
///   base model                      38.8 %  ##############################
///   uncertain properties fitted     30.1 %  #######################
///   + added-mass at node 201         3.8 %  ###
///   floor                            3.1 %  ##
[[nodiscard]] std::string ladder_text(const updating::Diagnosis& diagnosis);

}  // namespace tapfit::tui
