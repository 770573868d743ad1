// Forms that a deck lacks mass for, linear in their share s:
//
//   M(s) = M + s M_1
//
// with M_1 the mass of the deck with the form less its own.
#pragma once

#include "updating/corrections/correction.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <memory>
#include <set>
#include <vector>

namespace tapfit::updating {

struct MassForm {
  Correction correction;
  std::shared_ptr<const structure::Deck> deck;  ///< with the form
  structure::SparseMatrix M;                    ///< M_1, dofs square
};

/// @param system of the deck
[[nodiscard]] std::vector<MassForm> mass_forms(const structure::Deck& deck,
                                               const structure::System& system);

/// M_1 of some elements.
[[nodiscard]] structure::SparseMatrix mass_of(const MassForm& form,
                                              const structure::Deck& deck,
                                              const std::set<int>& elements);

}  // namespace tapfit::updating
