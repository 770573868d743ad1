// Patches of elements that may have lost stiffness together.
#pragma once

#include "updating/structure/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// Each shell and bar alone; growing boxes of them around the middle of each
/// and around each grid, up to a quarter of all; all of a property where that
/// is not most of the structure. Every set once, ids ascending.
[[nodiscard]] std::vector<std::vector<int>> element_patches(
    const structure::Deck& deck);

}  // namespace tapfit::updating
