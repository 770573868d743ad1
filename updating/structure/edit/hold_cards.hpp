// SPC1 cards: what holds grids, in the set that the deck is held by.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// The set that the case control selects (SPC = n), else that of the deck's
/// first SPC or SPC1, else 1.
[[nodiscard]] int constraint_set(const Deck& deck);

/// Cards that hold components along basic axes: one for all grids that are held
/// in the same. Where no component along a grid's own axes (CD) is the one
/// meant, a comment says so.
[[nodiscard]] std::vector<std::string> hold_cards(
    const Deck& deck, const std::vector<Constraint>& held);

}  // namespace tapfit::structure
