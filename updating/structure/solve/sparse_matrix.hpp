// Matrices of which few entries are not zero.
#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace tapfit::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Rows and columns of A at the given indices.
[[nodiscard]] SparseMatrix extract(const SparseMatrix& A,
                                   const std::vector<int>& indices);

}  // namespace tapfit::structure
