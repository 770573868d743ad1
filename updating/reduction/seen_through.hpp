// Large symmetric matrices seen through the vectors of a base. One that acts on
// few degrees of freedom, as the stiffness of some elements, costs no more than
// these.
#pragma once

#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// @param V n x a
/// @param A n x n, symmetric
/// @return V' A V, a x a
[[nodiscard]] Eigen::MatrixXd seen_through(const Eigen::MatrixXd& V,
                                           const structure::SparseMatrix& A);

/// @param V n x a, zero on the degrees of freedom that follow
/// @param R m x b, m >= n
/// @param A m x m, symmetric
/// @return [V R]' A R, (a + b) x b
[[nodiscard]] Eigen::MatrixXd seen_through(const Eigen::MatrixXd& V,
                                           const Eigen::MatrixXd& R,
                                           const structure::SparseMatrix& A);

}  // namespace tapfit::updating
