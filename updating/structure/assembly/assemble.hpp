// The room updating/structure/assembly. From a deck to matrices: all elements,
// constraints, rigid elements, degrees of freedom without stiffness; the modes
// of a deck.
// In:  Deck in SI.
// Out: System: K, M and which degrees of freedom may move.
// May include: its row in CONTRIBUTING.md.
//
// Stiffness and mass matrices of a deck.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <functional>
#include <vector>

namespace tapfit::structure {

/// Assembles every element of the deck.
///
/// @throws InputError naming the element for a bad shape (zero area, wrong
///   node order) or missing property
[[nodiscard]] System assemble(const Deck& deck);

/// Stiffness (or mass) of only the shells, bars, rods and solids that `wanted`
/// accepts by element id (asked on several threads); for groups and local
/// losses.
[[nodiscard]] SparseMatrix assemble_stiffness(
    const Deck& deck, const std::function<bool(int element_id)>& wanted);
[[nodiscard]] SparseMatrix assemble_mass(
    const Deck& deck, const std::function<bool(int element_id)>& wanted);

/// Ids of the elements whose material is the one given.
[[nodiscard]] std::vector<int> elements_of_material(const Deck& deck, int id);

/// Total mass in translation [kg].
[[nodiscard]] double total_mass(const Deck& deck, const System& system);
/// The same of a part of it, M over all degrees of freedom.
[[nodiscard]] double total_mass(const Deck& deck, const SparseMatrix& M);

}  // namespace tapfit::structure
