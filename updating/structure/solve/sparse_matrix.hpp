// Matrices of which few entries are not zero.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace tapfit::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Rows and columns of A at the given indices.
[[nodiscard]] SparseMatrix extract(const SparseMatrix& A,
                                   const std::vector<int>& indices);

/// A X. Each entry of A is read once and taken times a row of X, whose entries
/// lie side by side for that: Eigen's own A * X reads all of A for each column.
/// @param X as many rows as A has columns
[[nodiscard]] Eigen::MatrixXd product(const SparseMatrix& A,
                                      const Eigen::MatrixXd& X);

}  // namespace tapfit::structure
