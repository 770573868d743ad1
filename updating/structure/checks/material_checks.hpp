// What a deck's materials give away: units that are not the ones taken, and
// densities that were forgotten.
#pragma once

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// Materials that no solid has, in words: a modulus or a speed of sound far
/// out, as where a deck in millimetres and tonnes is taken for SI.
/// @param deck in SI units
[[nodiscard]] std::vector<std::string> material_unit_warnings(const Deck& deck);

/// That `what`, with the materials without density as its place.
[[nodiscard]] InputError no_density(const Deck& deck, const std::string& what);

}  // namespace tapfit::structure
