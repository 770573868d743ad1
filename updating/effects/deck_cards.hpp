// Bulk data cards for identified effects, with element ids that are free and in
// the units of the deck's own file. Sizes are given in SI.
#pragma once

#include "updating/structure/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::effects {

/// CONM2 with the `offset`-th free element id of the deck (0, 1, ...).
[[nodiscard]] std::string point_mass_card(const structure::Deck& deck,
                                          int offset,
                                          int node,
                                          double mass_kg);

/// CELAS2 from a grid's component to ground.
[[nodiscard]] std::string ground_spring_card(const structure::Deck& deck,
                                             int offset,
                                             int node,
                                             int component,
                                             double stiffness);

/// CDAMP2 from a grid's component to ground.
[[nodiscard]] std::string ground_damper_card(const structure::Deck& deck,
                                             int offset,
                                             int node,
                                             int component,
                                             double damping);

/// A grid of its own with a mass, on a spring and damper to a grid.
[[nodiscard]] std::vector<std::string> absorber_cards(
    const structure::Deck& deck,
    int node,
    int component,
    double mass_kg,
    double stiffness,
    double damping);

}  // namespace tapfit::effects
