// How the grids' motions follow from those that may be chosen,
//
//   u = T q
//
// u: six per grid along basic axes. q: the same numbering, along the grid's own
// axes where constraints turn it; components that follow a rigid element have
// an empty column. A grid at x_d follows one at x_i as
//
//   u_d = u_i + theta_i x (x_d - x_i),   theta_d = theta_i
//
// in the components that its element names. A component that a relation (MPC,
// RBE3) names is the sum of its terms. What leads one may follow another.
// Source: MSC Nastran Linear Static Analysis User's Guide, "R-type elements".
#pragma once

#include "updating/structure/deck/constraint_axes.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/SparseCore>

namespace tapfit::structure {

/// @param axes of the same deck
/// @return 6 n_grids square; 0 x 0 for a deck without rigid elements and turned
///   grids, where u = q
/// @throws InputError for a component that follows two elements, that follows
///   itself round a ring, or that is held besides
[[nodiscard]] Eigen::SparseMatrix<double> multipoint_constraints(
    const Deck& deck, const ConstraintAxes& axes);

}  // namespace tapfit::structure
