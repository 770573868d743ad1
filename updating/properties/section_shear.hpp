// The shear of sections that a deck leaves out. A PBAR without K1 and K2 bends
// without shearing; every real section shears as well:
//
//   phi = 12 E I / (k A G L^2),   k = 5/6 / s
//
// s = 0 is the deck as it stands, 1 a solid rectangle (k = 5/6), 2 to 3 a thin
// wall.
// Source: G. R. Cowper, "The Shear Coefficient in Timoshenko's Beam Theory",
// J. Appl. Mech. 33 (1966).
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <set>

namespace tapfit::updating {

/// Its name as a correction of the model and in results.
inline constexpr const char* section_shear = "section-shear";

/// Properties of bars that do not shear, ascending.
[[nodiscard]] std::set<int> shearless_sections(const structure::Deck& deck);

/// The deck with these sections' shear; without it where `share` is 0.
/// @param sections from shearless_sections()
/// @param share s, not below 0
[[nodiscard]] structure::Deck with_section_shear(structure::Deck deck,
                                                 const std::set<int>& sections,
                                                 double share);

/// K1 and K2 of a share; 0, none, for 0.
[[nodiscard]] double shear_coefficient(double share);

}  // namespace tapfit::updating
