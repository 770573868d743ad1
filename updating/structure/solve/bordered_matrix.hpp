// A large sparse symmetric matrix, shared by many, with a few entries and
// degrees of freedom more:
//
//   A = [ A_0  0 ] + B
//       [ 0    0 ]
//
// B sparse, of A's size, with few entries.
#pragma once

#include "updating/structure/solve/sparse_matrix.hpp"

#include <Eigen/Core>

namespace tapfit::structure {

/// A view: A_0 must outlive it and its copies.
class BorderedMatrix {
 public:
  BorderedMatrix() = default;
  /// A_0 alone, full storage.
  BorderedMatrix(const SparseMatrix& shared) : shared_(&shared) {}
  BorderedMatrix(SparseMatrix&&) = delete;

  [[nodiscard]] Eigen::Index rows() const;
  [[nodiscard]] const SparseMatrix& shared() const;  ///< A_0
  [[nodiscard]] const SparseMatrix& border() const { return border_; }
  [[nodiscard]] bool is_zero() const;
  [[nodiscard]] double diagonal(Eigen::Index k) const;

  /// @param more symmetric, as large as A or larger
  void add(const SparseMatrix& more);

  /// A X for a few sparse columns, rows() of them.
  [[nodiscard]] SparseMatrix times(const SparseMatrix& X) const;
  /// In one piece.
  [[nodiscard]] SparseMatrix whole() const;

 private:
  const SparseMatrix* shared_ = nullptr;
  SparseMatrix border_;  // 0 x 0: none
};

/// A X, rows x columns.
[[nodiscard]] Eigen::MatrixXd symmetric_product(
    const BorderedMatrix& A, const Eigen::Ref<const Eigen::MatrixXd>& X);

}  // namespace tapfit::structure
