// DMIG: a symmetric stiffness matrix by degrees of freedom, one triangle of it,
// in the units of the deck's own file.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <Eigen/SparseCore>

#include <string>
#include <vector>

namespace tapfit::structure {

/// @param K 6 entries per grid of the deck, along basic axes [SI]
/// @return the head and one card per column, with its continuations; none
///   where a grid that K acts on has displacement axes of its own
[[nodiscard]] std::vector<std::string> direct_stiffness_cards(
    const Deck& deck,
    const std::string& name,
    const Eigen::SparseMatrix<double>& K);

/// Puts "K2GG = name" into the case control, if no line there says K2GG.
void name_direct_stiffness(const std::string& name, EditedDeck& deck);

}  // namespace tapfit::structure
