// Bulk data cards for identified effects, with element ids that are free and in
// the units of the deck's own file. Sizes are given in SI, components along
// basic axes; cards say them along the displacement axes (CD) of their grid.
// Where none of these is the direction meant, they act on a grid of their own
// (basic axes) that follows the other by an RBE2.
#pragma once

#include "updating/structure/deck.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::effects {

/// CONM2 with the `offset`-th free element id of the deck (0, 1, ...).
[[nodiscard]] std::string point_mass_card(const structure::Deck& deck,
                                          int offset,
                                          int node,
                                          double mass_kg);

/// The component by which cards at a grid mean a direction along basic axes, in
/// either sense; empty where the grid's axes are askew to it.
[[nodiscard]] std::optional<int> card_component(const structure::Deck& deck,
                                                int node,
                                                int component);

/// CELAS2 from a grid's component to ground, with what it needs in front of it.
/// Takes no more ids, from the `offset`-th on, than there are cards.
[[nodiscard]] std::vector<std::string> ground_spring_cards(
    const structure::Deck& deck,
    int offset,
    int node,
    int component,
    double stiffness);

/// CDAMP2 alike.
[[nodiscard]] std::vector<std::string> ground_damper_cards(
    const structure::Deck& deck,
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
