// Stiffness and mass of a structure, and what of it may move.
#pragma once

#include "updating/structure/solve/sparse_matrix.hpp"

#include <vector>

namespace tapfit::structure {

/// Matrices over all degrees of freedom u, six per grid along basic axes:
/// index = 6 * grid_index + component - 1. Constraints are not applied here but
/// listed, so that a support can be given some compliance later. Rigid elements
/// and turned grids are in u = T q, q numbered alike (see
/// multipoint_constraints.hpp).
struct System {
  SparseMatrix K;           ///< full symmetric storage [N/m]
  SparseMatrix M;           ///< [kg]
  std::vector<bool> fixed;  ///< of q: held by a constraint
  std::vector<bool>
      inactive;         ///< of q: follows, or without stiffness (AUTOSPC)
  SparseMatrix T = {};  ///< dofs square; 0 x 0 where u = q

  [[nodiscard]] Eigen::Index dofs() const { return K.rows(); }
  /// Indices of q that are neither fixed nor inactive.
  [[nodiscard]] std::vector<int> free_dofs() const;
};

}  // namespace tapfit::structure
