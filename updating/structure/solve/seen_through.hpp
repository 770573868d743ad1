// Large symmetric matrices seen through the vectors of a base. One that acts on
// few degrees of freedom, as the stiffness of some elements, costs no more than
// these.
#pragma once

#include "updating/structure/solve/bordered_matrix.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::structure {

/// A symmetric matrix on no more than what it acts on.
struct Acting {
  std::vector<Eigen::Index> dofs;  ///< ascending
  SparseMatrix A;                  ///< dofs square

  /// Rows of X there, zero behind its last one.
  [[nodiscard]] Eigen::MatrixXd rows_of(const Eigen::MatrixXd& X) const;
  /// The opposite: `rows` there, zero elsewhere, n x columns.
  [[nodiscard]] Eigen::MatrixXd spread(const Eigen::MatrixXd& rows,
                                       Eigen::Index n) const;
};

[[nodiscard]] Acting acting(const SparseMatrix& A);

/// @param V n x a
/// @param A n x n, symmetric
/// @return V' A V, a x a
[[nodiscard]] Eigen::MatrixXd seen_through(const Eigen::MatrixXd& V,
                                           const SparseMatrix& A);

/// @param V n x a, zero on the degrees of freedom that follow
/// @param R m x b, m >= n
/// @param A symmetric, of n to m rows; zero behind its last one
/// @return [V R]' A R, (a + b) x b
[[nodiscard]] Eigen::MatrixXd seen_through(const Eigen::MatrixXd& V,
                                           const Eigen::MatrixXd& R,
                                           const SparseMatrix& A);

[[nodiscard]] Eigen::MatrixXd seen_through(const Eigen::MatrixXd& V,
                                           const Eigen::MatrixXd& R,
                                           const BorderedMatrix& A);

/// The same matrix through all of them, where A acts on few degrees of freedom.
/// @return [V R]' A [V R], (a + b) square
[[nodiscard]] Eigen::MatrixXd seen_through_all(const Eigen::MatrixXd& V,
                                               const Eigen::MatrixXd& R,
                                               const SparseMatrix& A);

}  // namespace tapfit::structure
