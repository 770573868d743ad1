// What a deck's materials give away: units that are not the ones taken, and
// densities that were forgotten.
#pragma once

#include "updating/structure/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// Materials that no solid has, in words: a modulus or a speed of sound far
/// out, as where a deck in millimetres and tonnes is taken for SI.
/// @param deck in SI units
[[nodiscard]] std::vector<std::string> material_unit_warnings(const Deck& deck);

/// Names the materials without density.
/// @throws InputError always, with `what` as its message
[[noreturn]] void refuse_without_density(const Deck& deck,
                                         const std::string& what);

}  // namespace tapfit::structure
