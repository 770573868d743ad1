// A factored sparse symmetric matrix (CHOLMOD), kept for many solves.
#pragma once

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/solve/system.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tapfit::structure {

/// Thrown by Factor: elimination came to nothing.
class SingularMatrix : public InputError {
 public:
  explicit SingularMatrix(Eigen::Index row);

  /// The row that was eliminated last; a mechanism moves it.
  [[nodiscard]] Eigen::Index row() const { return row_; }

 private:
  Eigen::Index row_;
};

/// A = L L' or L D L', factored once. Movable, not copyable.
class Factor {
 public:
  /// @param A symmetric, full storage, not singular to working precision
  /// @throws SingularMatrix when A cannot be factored (a mechanism, a loose
  ///   part)
  explicit Factor(const SparseMatrix& A);
  /// The same, eliminated in the order of another one: as good and quicker
  /// where the two have their entries at the same places.
  /// @param like of as many rows
  Factor(const SparseMatrix& A, const Factor& like);
  ~Factor();
  Factor(Factor&&) noexcept;
  Factor& operator=(Factor&&) noexcept;

  /// A^-1 B for dense B, n x k; on several threads at once if need be.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

  /// What elimination divided by, per row of A. All are positive if and only if
  /// A is positive definite.
  [[nodiscard]] Eigen::VectorXd pivots() const;

 private:
  struct Impl;
  void take(const SparseMatrix& A, const Factor* like);

  std::unique_ptr<Impl> impl_;
};

/// Where L has entries, for an ordering that keeps them few: neighbouring
/// columns with the same rows below are one supernode.
struct Supernodes {
  std::vector<int> order;       ///< order[k]: the row of A eliminated as k-th
  std::vector<int> first;       ///< per supernode its first column, then n
  std::vector<int> rows_begin;  ///< per supernode its start in `rows`, then end
  std::vector<int> rows;        ///< ascending; begins with its own columns
  std::vector<int> owner;       ///< supernode of a column

  [[nodiscard]] std::size_t count() const { return first.size() - 1; }
  [[nodiscard]] int columns(std::size_t supernode) const {
    return first[supernode + 1] - first[supernode];
  }
};

/// @param A symmetric, full storage; only the pattern counts
[[nodiscard]] Supernodes supernodes(const SparseMatrix& A);

/// The version of CHOLMOD that is in use.
[[nodiscard]] std::string sparse_library();

}  // namespace tapfit::structure
