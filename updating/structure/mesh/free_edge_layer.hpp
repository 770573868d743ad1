// What a mesh of shells lacks along its free edges.
//
// Within about delta of a free edge a plate carries no twist: there the shear
// stress that goes with it turns into transverse shear,
//
//   delta = sqrt(D_66 / S),   D_66 its twisting, S its transverse shear
//                             stiffness along the edge,
//
// 0.316 t where it is isotropic, so that a strip of width b twists with
// G b t^3 / 3 (1 - 0.63 t / b), the textbook's constant of a flat rectangle.
// Elements many times wider than delta twist to their very edge, and are too
// stiff by the twist of a width delta.
//
// Source: S. Timoshenko, J. N. Goodier, "Theory of Elasticity", 3rd ed., 1970,
// art. 109; B. Haggblad, K.-J. Bathe, "Specifications of boundary conditions
// for Reissner/Mindlin plate bending finite elements", Int. J. Numer. Meth.
// Engng 30, 1990, p. 981 (edge layer).
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

namespace tapfit::structure {

/// What the shells at free edges (sides of one shell only) are too stiff by,
/// to be taken off: positive semidefinite, of the size of the system. Of an
/// element's twist at most a quarter for each side: finer meshes see the layer
/// themselves.
/// Zero for shells without transverse shear, and where there are none.
[[nodiscard]] SparseMatrix free_edge_layer(const Deck& deck);

}  // namespace tapfit::structure
