// What a preprocessor left double: grids that were not merged, elements on top
// of each other.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// Grids at one place, each with elements of its own and nothing between them,
/// and shells on the same grids, in words.
[[nodiscard]] std::vector<std::string> doubled_part_warnings(const Deck& deck);

}  // namespace tapfit::structure
