// Forms that a careful engineer's deck may have left out: the same deck with
// one of them, for the corrections of the model.
#pragma once

#include "updating/reduction/base_matrices.hpp"
#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// Its name in results; see stiff_corners.hpp.
inline constexpr const char* corner_stiffness = "corner-stiffness";

struct DeckForm {
  Correction correction;
  structure::Deck deck;
};

/// The shear of sections (section_shear.hpp) and corners as stiff as they are
/// (stiff_corners.hpp), where the deck lacks them.
[[nodiscard]] std::vector<DeckForm> deck_forms(const structure::Deck& deck);

}  // namespace tapfit::updating
