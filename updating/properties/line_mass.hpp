// Mass that a deck has on lines. That of a CBAR lies on its line; that of every
// real bar turns with its sections as well, about the bar's axis and across it:
//
//   J_m = rho (I1 + I2),   rho I1,   rho I2   [kg m^2 per m]
//
// and where members meet, some of it is counted twice and some is not there
// (corner_mass.hpp).
// Source: S. Timoshenko, D. H. Young, W. Weaver, "Vibration Problems in
// Engineering", 4th ed., 1974, art. 5.7 and 5.12.
#pragma once

#include "updating/structure/deck/deck.hpp"

namespace tapfit::updating {

/// Its name as a correction of the model and in results.
inline constexpr const char* line_mass = "line-mass";

/// Whether bars have mass on their lines alone, or twice.
[[nodiscard]] bool has_line_mass(const structure::Deck& deck);

/// The deck with the mass of every bar over its sections, and once.
[[nodiscard]] structure::Deck without_line_mass(structure::Deck deck);

}  // namespace tapfit::updating
