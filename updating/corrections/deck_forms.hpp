// Forms that a careful engineer's deck may have left out: the same deck with
// one of them, for the corrections of the model.
#pragma once

#include "updating/corrections/correction.hpp"
#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

struct DeckForm {
  Correction correction;
  structure::Deck deck;
  bool of_mass = false;  ///< alone
};

/// The shear of sections (section_shear.hpp), corners as stiff as they are
/// (stiff_corners.hpp) and the mass of sections (line_mass.hpp), where the deck
/// lacks them.
[[nodiscard]] std::vector<DeckForm> deck_forms(const structure::Deck& deck);

}  // namespace tapfit::updating
