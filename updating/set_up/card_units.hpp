// Numbers of a deck's cards that were given in another unit than the deck's:
// those that no structure has as they stand, and has in that unit.
#pragma once

#include "updating/set_up/card_slip.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// Every unit that may be taken for the deck's, as a kind of slip: "E-in-MPa",
/// "RHO-in-g/cm3", "T-in-mm", "section-in-mm".
[[nodiscard]] const std::vector<std::string>& unit_slip_kinds();

/// Of all cards with a number that is out of scale in the same way at once: a
/// modulus or density that no solid has (unit_checks.hpp), a thickness or a
/// section that is longer than half of the structure. Rigid parts are often
/// given as such sections; the measurement tells.
/// @param deck in SI units
[[nodiscard]] std::vector<CardSlip> unit_slips_of(const structure::Deck& deck);

}  // namespace tapfit::updating
