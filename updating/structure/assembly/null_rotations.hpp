// Turns of grids that nothing resists and that carry no inertia, such as the
// twist of a straight line of CBARs, whose cross sections have none. With such
// a motion v,
//
//   K v = 0,   M v = 0,   v without translations
//
// (K - shift M) is singular whatever the shift. Holding one component that v
// moves changes neither a frequency nor a translation of any mode, for every
// mode plus a multiple of v is the same mode.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <vector>

namespace tapfit::structure {

/// Entries of q to hold, one for each independent such motion; ascending.
/// Looked for among grids without shells, whose rotations always carry
/// stiffness.
/// @param system all but this done; without negative stiffness
[[nodiscard]] std::vector<int> null_rotations(const Deck& deck,
                                              const System& system);

}  // namespace tapfit::structure
