// Patches of elements that may have lost stiffness together.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// Each of element_cells() alone; growing boxes of them around the middle of
/// each, around grids and edges of shells, up to a quarter of all; bars in
/// line; all of a property where that is not most of the structure. Every set
/// once, ids ascending.
[[nodiscard]] std::vector<std::vector<int>> element_patches(
    const structure::Deck& deck);

}  // namespace tapfit::updating
