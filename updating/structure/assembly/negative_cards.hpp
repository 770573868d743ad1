// Cards of springs and masses below zero, which a structure can have only as
// long as every motion has energy.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

namespace tapfit::structure {

/// Refuses a structure of negative energy, naming the cards below zero. Costs
/// nothing for a deck without such cards, which cannot be indefinite.
void refuse_negative_cards(const Deck& deck, const System& system);

}  // namespace tapfit::structure
