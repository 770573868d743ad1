// Numbers of a deck's cards that are easily written down wrongly: two that were
// exchanged, half of a thickness in the place of the whole, or what stands in
// another unit than the deck's.
#pragma once

#include "updating/places/location.hpp"
#include "updating/set_up/card_slip.hpp"
#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// Of card_slips().
[[nodiscard]] const std::vector<std::string>& slip_kinds();

/// In the order in which they are tried, of cards that elements use, those of
/// most elements first: other units (card_units.hpp), I1 and I2 of bars that
/// bend in both planes, E1 and E2 of a MAT8, then the thickness of a PSHELL
/// doubled and halved. Numbers within a percent of each other are not
/// exchanged: no measurement tells.
[[nodiscard]] std::vector<CardSlip> card_slips(const structure::Deck& deck);

/// Those of the kind that is a place's variant, on its elements.
[[nodiscard]] std::vector<CardSlip> slips_at(const structure::Deck& deck,
                                             const Location& where);

}  // namespace tapfit::updating
