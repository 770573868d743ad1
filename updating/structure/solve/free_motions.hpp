// The motions that constraints leave free,
//
//   u = T q,   T' K T q = omega^2 T' M T q
//
// with as many columns of T as q has entries that are neither held, inactive
// nor following. Where no grid is turned or follows, T only picks rows, and no
// product is taken.
#pragma once

#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::structure {

struct FreeMotions {
  std::vector<int> free;  ///< entries of the system's q, ascending
  Eigen::Index dofs = 0;  ///< of u
  SparseMatrix T;         ///< dofs x free; 0 x 0 where it only picks rows

  [[nodiscard]] Eigen::Index size() const {
    return static_cast<Eigen::Index>(free.size());
  }
  /// T' A T, size() square, symmetric for a symmetric A.
  [[nodiscard]] SparseMatrix reduce(const SparseMatrix& A) const;
  /// T q, dofs x columns.
  [[nodiscard]] Eigen::MatrixXd expand(const Eigen::MatrixXd& q) const;
  /// Forces on q from forces on u, T' f: size() x columns.
  [[nodiscard]] Eigen::MatrixXd project(const Eigen::MatrixXd& forces) const;
};

[[nodiscard]] FreeMotions free_motions(const System& system);

/// u where one entry of q is 1 and all others are 0.
/// @param T as System::T; entries of q behind its last stand for themselves
/// @param of which entries
/// @param dofs rows of the result
/// @return dofs x one per entry
[[nodiscard]] SparseMatrix unit_motions(const SparseMatrix& T,
                                        const std::vector<int>& of,
                                        Eigen::Index dofs);

}  // namespace tapfit::structure
