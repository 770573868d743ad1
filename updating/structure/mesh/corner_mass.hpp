// The mass of bars at corners, where it is. A member that ends inside one that
// goes on has its material there counted twice: that is too much. Two that end
// in each other are a block about the crossing; their lines have one quarter
// of it twice, and one not at all: the block is as heavy as what their lines
// have inside it, and turns as a cuboid does.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>

namespace tapfit::structure {

/// Bars whose mass is counted twice or lies elsewhere, and the share of it:
/// 0.9 at most, so that something is left.
[[nodiscard]] std::map<int, double> misplaced_mass(const Deck& deck);

/// The deck with that mass where it is; what is no material's stays.
[[nodiscard]] Deck with_placed_mass(Deck deck);

}  // namespace tapfit::structure
