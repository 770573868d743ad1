// Where a structure is likely to be held that the deck leaves free there: the
// ends of its box, its straight edges, the ends of its bars and its corners.
//
// How it is held there is said by a variant, see held_support.hpp.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// Grids of each likely clamp, ascending, each set once:
///  - those on an end of the box around the structure, along each axis in which
///    it extends; each part of an end by itself where elements do not join all
///    of it; both ends of an axis together,
///  - the longest free edges of shells, from one corner to the next (around a
///    hole the whole of it),
///  - ends of bars,
///  - the corners where such edges meet, all together and those of each end.
///
/// Grids that the deck holds wholly are in none of them, and none holds more
/// than half of those that it does not.
[[nodiscard]] std::vector<std::vector<int>> clamp_places(
    const structure::Deck& deck);

}  // namespace tapfit::updating
