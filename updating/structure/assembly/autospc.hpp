// Degrees of freedom that are held though no constraint names them (AUTOSPC):
// those without stiffness of their own, and turns that nothing resists and that
// carry nothing.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// Entries of q without stiffness: less than 1e-12 of the stiffest component of
/// the same kind (translation, rotation) at the grid, which is rounding. What a
/// spring acts on is kept however soft the spring is. What follows a rigid
/// element has no stiffness of its own and is among them.
/// @param system K and T are read
[[nodiscard]] std::vector<bool> without_stiffness(const Deck& deck,
                                                  const System& system);

/// One sentence when some of the inactive entries of q carry mass or inertia:
/// these motions are lost to the model. Another when idle turns are held.
[[nodiscard]] std::vector<std::string> autospc_warnings(const Deck& deck,
                                                        const System& system);

}  // namespace tapfit::structure
