// How much of a stiffness that is added is much.
//
// To first order p S raises a mode's omega^2 by p phi' S phi. Where S is below
// zero the structure buckles at the least p with K u = -p S u.
#pragma once

#include "updating/reduction/stiffness_change.hpp"
#include "updating/structure/solve/sparse_matrix.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// From 1e-4 to 10 times what doubles omega^2 of the mode in the band that
/// rises most; of what softens, up to 0.9 of what buckles the structure, as the
/// modes have it.
/// @param modes n x count, of unit mass
[[nodiscard]] ChangeRange added_range(const structure::SparseMatrix& S,
                                      const Eigen::MatrixXd& modes,
                                      const Eigen::VectorXd& modes_hz,
                                      double high_hz);

}  // namespace tapfit::updating
