// Components taken out of a deck's own constraints.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <vector>

namespace tapfit::structure {

/// Gives SPC, SPC1 and GRID cards that hold a released component anew without
/// it, whatever their set, and the RBE2 and RBAR by which a held grid holds
/// others. What they hold besides stays held.
///
/// @param deck that the cards are of
/// @param released components along the grids' own axes
[[nodiscard]] CardEdit release_constraints(
    const Deck& deck, const std::vector<Constraint>& released);

}  // namespace tapfit::structure
