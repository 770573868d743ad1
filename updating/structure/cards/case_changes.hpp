// What a case control asks for that changes stiffness or mass and is not read:
// a static preload, temperatures of materials, nonstructural mass, matrices of
// dynamic responses.
#pragma once

#include "updating/structure/abaqus/left_out.hpp"
#include "updating/structure/cards/case_control.hpp"

#include <set>
#include <string>
#include <vector>

namespace tapfit::structure {

struct CaseChanges {
  std::vector<LeftOut> left_out;      ///< what the model lacks
  std::vector<std::string> warnings;  ///< what only looks as if
};

/// @param cards names of those that the deck has
[[nodiscard]] CaseChanges case_changes(const CaseControl& control,
                                       const std::set<std::string>& cards);

}  // namespace tapfit::structure
