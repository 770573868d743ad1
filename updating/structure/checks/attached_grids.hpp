// The room updating/structure/checks. What a deck gives away by itself, before
// anything is solved: loose grids, doubled parts, odd shapes, wrong units.
// In:  A deck.
// Out: Sentences for the user, or an InputError.
// May include: its row in CONTRIBUTING.md.
//
// Grids that something with stiffness holds in the model, and cards on grids
// that nothing holds.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/deck/deck.hpp"

#include <set>

namespace tapfit::structure {

/// Ids of the grids that an element with stiffness or a rigid element
/// connects. A mass or a dashpot alone attaches nothing.
[[nodiscard]] std::set<int> attached_grids(const Deck& deck);

/// Adds warnings for grids that are attached to nothing and for masses that
/// sit on such grids.
/// @param bulk the cards that the deck was read from
void warn_unattached(const BulkData& bulk, Deck& deck);

}  // namespace tapfit::structure
