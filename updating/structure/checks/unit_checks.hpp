// What a deck's numbers give away: units that are not the ones taken, and
// densities that were forgotten.
#pragma once

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// Whether a modulus [Pa] and a density [kg/m^3], 0 for none, are those of a
/// solid: from soft foam to beyond diamond, nothing dense as slow as rubber
/// (Ashby, Materials Selection in Mechanical Design, chart of E over density).
[[nodiscard]] bool is_solid(double modulus, double density);

/// From corner to corner of all grids [m].
[[nodiscard]] double size_of(const Deck& deck);

/// Whether a thickness or the side of a section is more than half of a
/// structure of that size.
[[nodiscard]] bool is_too_long(double length, double size);

/// Materials that no solid has, as where a deck in millimetres and tonnes is
/// taken for SI, and shells that are too thick, in words. Sections of bars are
/// not among them: rigid parts are often given as such.
/// @param deck in SI units
[[nodiscard]] std::vector<std::string> unit_warnings(const Deck& deck);

/// That `what`, with the materials without density as its place.
[[nodiscard]] InputError no_density(const Deck& deck, const std::string& what);

}  // namespace tapfit::structure
