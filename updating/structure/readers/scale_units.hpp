// A deck in other units brought to SI.
#pragma once

#include "updating/structure/deck/deck.hpp"

namespace tapfit::structure {

/// Converts every quantity of the deck to SI; `cards` stay as written.
///
/// @param units "SI" (nothing to do); "mm-t-s": millimetre, tonne, second, and
///   so newton, megapascal, t/mm^3; "in-lbf-s": inch, pound-force, second, and
///   so psi and lbf s^2/in for masses (what PARAM,WTMASS makes of pounds)
/// @throws InputError for other units
void scale_to_si(Deck& deck, const std::string& units);

}  // namespace tapfit::structure
