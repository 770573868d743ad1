// A sparse symmetric matrix times many columns,
//
//   Y = A X,   y_i = sum_j A_ij x_j,   x_j the rows of X.
//
// Column i of A, which is its row i as well, meets several columns of X at a
// time: A is read once for them, and their sums stay in registers.
#pragma once

#include "updating/structure/solve/sparse_matrix.hpp"

#include <Eigen/Core>

namespace tapfit::structure {

/// @param A n x n, symmetric, full storage
/// @param X n x columns
[[nodiscard]] Eigen::MatrixXd symmetric_product(
    const SparseMatrix& A, const Eigen::Ref<const Eigen::MatrixXd>& X);

}  // namespace tapfit::structure
