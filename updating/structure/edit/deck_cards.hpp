// Bulk data cards for identified effects, with element ids that are free and in
// the units of the deck's own file. Sizes are given in SI, components along
// basic axes; cards say them along the displacement axes (CD) of their grid.
// Where none of these is the direction meant, they act on a grid of their own
// (basic axes) that follows the other by an RBE2.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// The `offset`-th element (or grid) id that the deck has not (0, 1, ...).
[[nodiscard]] int free_element(const Deck& deck, int offset);
[[nodiscard]] int free_grid(const Deck& deck, int offset);

/// A real in bulk data needs a point or an exponent with one.
[[nodiscard]] std::string card_real(double value);

/// A stiffness, damping [SI] in the file's units: force by length is mass by
/// time squared; a rotation (component 4..6) has a length at either end.
[[nodiscard]] double file_stiffness(const Deck& deck, int component, double si);

/// GRID at the place of another one. Zeros stand where blanks would take what
/// GRDSET says.
/// @param held components of its own constraint, or none
/// @param axes coordinate system of its displacements (CD)
[[nodiscard]] std::string grid_card(
    const Deck& deck, int id, int like, const std::string& held, int axes = 0);

/// A grid with basic axes at any place, and the rigid arm by which it follows
/// another: what lies between grids is moved and turned by the nearest.
/// @param at basic axes [m]
[[nodiscard]] std::vector<std::string> grid_on_arm(const Deck& deck,
                                                   int node,
                                                   const Eigen::Vector3d& at);

/// CONM2 with the `offset`-th free element id of the deck (0, 1, ...).
/// @param inertia_kg_m2 about each axis; a second line where there is one
[[nodiscard]] std::string point_mass_card(const Deck& deck,
                                          int offset,
                                          int node,
                                          double mass_kg,
                                          double inertia_kg_m2 = 0.0);

/// The component by which cards at a grid mean a direction along basic axes, in
/// either sense; empty where the grid's axes are askew to it.
[[nodiscard]] std::optional<int> card_component(const Deck& deck,
                                                int node,
                                                int component);

/// CELAS2 from a grid's component to ground, with what it needs in front of it.
/// Takes no more ids, from the `offset`-th on, than there are cards.
[[nodiscard]] std::vector<std::string> ground_spring_cards(
    const Deck& deck, int offset, int node, int component, double stiffness);

/// CELAS2 between two components of a grid with basic axes, and from each to
/// ground, that together couple them by a stiffness and leave what each has to
/// ground as it is. Springs below zero belong to it.
/// @param stiffness off the diagonal [N, N m]
[[nodiscard]] std::vector<std::string> coupling_spring_cards(
    const Deck& deck,
    int offset,
    int node,
    std::array<int, 2> components,
    double stiffness);

/// CDAMP2 like ground_spring_cards().
[[nodiscard]] std::vector<std::string> ground_damper_cards(
    const Deck& deck, int offset, int node, int component, double damping);

/// A grid of its own with a mass, on a spring and damper to a grid.
[[nodiscard]] std::vector<std::string> absorber_cards(const Deck& deck,
                                                      int node,
                                                      int component,
                                                      double mass_kg,
                                                      double stiffness,
                                                      double damping);

}  // namespace tapfit::structure
