// Numbers of a deck's cards that are easily written down wrongly: two that were
// exchanged, or half of a thickness in the place of the whole. Each is a
// correction of the deck that can be tried; the file stays as it is.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct CardSlip {
  std::string edit;           ///< "model: PBAR 3, exchange I1 and I2"
  std::vector<int> elements;  ///< ids of those with the card, ascending
  std::function<void(structure::Deck&)> correct;
};

/// Of cards that elements use, exchanges first: I1 and I2 of bars that bend in
/// both planes, E1 and E2 of a MAT8, then the thickness of a PSHELL doubled and
/// halved. Numbers within a percent of each other are not exchanged: no
/// measurement tells.
[[nodiscard]] std::vector<CardSlip> card_slips(const structure::Deck& deck);

}  // namespace tapfit::updating
