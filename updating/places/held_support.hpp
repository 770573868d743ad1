// What held a structure that the deck leaves free there: at which grids, and in
// which of their components.
#pragma once

#include "updating/places/location.hpp"
#include "updating/structure/mesh/refined_deck.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// In what a place may be held besides: "held", "held-translations" (a hinge),
/// "held-X", "held-Y", "held-Z".
[[nodiscard]] std::vector<std::string> held_variants();

/// What one of these holds, digits of 1..6 along basic axes: "123"; empty for
/// other variants.
[[nodiscard]] std::string held_components(const std::string& variant);

/// Whether the variant is one of these.
[[nodiscard]] bool is_held(const Location& where);

/// What of a place the deck does not hold already. At grids that are held along
/// turned axes all that is named counts.
struct HeldGrid {
  int node = 0;
  std::string components;  ///< digits of 1..6, along basic axes
};
[[nodiscard]] std::vector<HeldGrid> newly_held(const structure::Deck& deck,
                                               const Location& where);

/// Of the mesh that is solved, for a place that is_held(): at its grids and at
/// those between them and what the deck holds.
/// @return degrees of freedom of u, ascending; of those that the deck holds
///   some may be among them
[[nodiscard]] std::vector<int> held_dofs(const structure::RefinedDeck& mesh,
                                         const Location& where);

}  // namespace tapfit::updating
