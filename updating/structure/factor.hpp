// A factored sparse symmetric matrix (CHOLMOD), kept for many solves.
#pragma once

#include "updating/structure/system.hpp"

#include <memory>

namespace tapfit::structure {

/// A = L L' or L D L', factored once. Movable, not copyable.
class Factor {
 public:
  /// @param A symmetric, full storage, not singular to working precision
  /// @throws InputError when A cannot be factored (a mechanism, a loose part)
  explicit Factor(const SparseMatrix& A);
  ~Factor();
  Factor(Factor&&) noexcept;
  Factor& operator=(Factor&&) noexcept;

  /// A^-1 B for dense B, n x k.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

  /// Number of negative pivots: eigenvalues below the shift (Sturm count).
  [[nodiscard]] Eigen::Index negative_pivots() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tapfit::structure
