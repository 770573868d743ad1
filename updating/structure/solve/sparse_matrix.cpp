#include "updating/structure/solve/sparse_matrix.hpp"

namespace tapfit::structure {

SparseMatrix extract(const SparseMatrix& A, const std::vector<int>& indices) {
  std::vector<int> place(static_cast<std::size_t>(A.rows()), -1);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    place[static_cast<std::size_t>(indices[i])] = static_cast<int>(i);
  }
  std::vector<Eigen::Triplet<double>> kept;
  kept.reserve(static_cast<std::size_t>(A.nonZeros()));
  for (int outer = 0; outer < A.outerSize(); ++outer) {
    const int col = place[static_cast<std::size_t>(outer)];
    if (col < 0) continue;
    for (SparseMatrix::InnerIterator it(A, outer); it; ++it) {
      const int row = place[static_cast<std::size_t>(it.row())];
      if (row >= 0) kept.emplace_back(row, col, it.value());
    }
  }
  const Eigen::Index n = static_cast<Eigen::Index>(indices.size());
  SparseMatrix result(n, n);
  result.setFromTriplets(kept.begin(), kept.end());
  return result;
}

Eigen::MatrixXd product(const SparseMatrix& A, const Eigen::MatrixXd& X) {
  using Rows =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Rows rows = X;
  const Rows AX = A * rows;
  return AX;
}

}  // namespace tapfit::structure
