#include "updating/structure/solve/seen_through.hpp"

#include "updating/structure/solve/symmetric_product.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::structure {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd Acting::rows_of(const MatrixXd& X) const {
  MatrixXd rows = MatrixXd::Zero(A.rows(), X.cols());
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    if (dofs[k] >= X.rows()) break;
    rows.row(static_cast<Index>(k)) = X.row(dofs[k]);
  }
  return rows;
}

MatrixXd Acting::spread(const MatrixXd& rows, Index n) const {
  MatrixXd X = MatrixXd::Zero(n, rows.cols());
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    X.row(dofs[k]) = rows.row(static_cast<Index>(k));
  }
  return X;
}

namespace {

std::vector<Index> acted_dofs(const SparseMatrix& A) {
  std::vector<Index> dofs;
  for (Index c = 0; c < A.outerSize(); ++c) {
    if (SparseMatrix::InnerIterator(A, c)) dofs.push_back(c);
  }
  return dofs;
}

Acting acting(const SparseMatrix& A, std::vector<Index> dofs) {
  Acting result;
  result.dofs = std::move(dofs);
  std::vector<int> at(static_cast<std::size_t>(A.cols()), -1);
  for (std::size_t k = 0; k < result.dofs.size(); ++k) {
    at[static_cast<std::size_t>(result.dofs[k])] = static_cast<int>(k);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const Index c : result.dofs) {
    for (SparseMatrix::InnerIterator it(A, c); it; ++it) {
      entries.emplace_back(at[static_cast<std::size_t>(it.row())],
                           at[static_cast<std::size_t>(c)],
                           it.value());
    }
  }
  const auto size = static_cast<Index>(result.dofs.size());
  result.A.resize(size, size);
  result.A.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

Acting acting(const SparseMatrix& A) { return acting(A, acted_dofs(A)); }

MatrixXd seen_through(const MatrixXd& V, const SparseMatrix& A) {
  return seen_through(MatrixXd(V.rows(), 0), V, A);
}

MatrixXd seen_through(const MatrixXd& V,
                      const MatrixXd& R,
                      const SparseMatrix& A) {
  MatrixXd both(V.cols() + R.cols(), R.cols());
  std::vector<Index> dofs = acted_dofs(A);
  if (2 * static_cast<Index>(dofs.size()) > A.rows()) {
    constexpr Index width = 64;  // A R of all columns would be as large as R
    for (Index first = 0; first < R.cols(); first += width) {
      const Index count = std::min(width, R.cols() - first);
      const MatrixXd AR =
          symmetric_product(A, R.topRows(A.rows()).middleCols(first, count));
      auto seen = both.middleCols(first, count);
      seen.topRows(V.cols()).noalias() = V.transpose() * AR.topRows(V.rows());
      seen.bottomRows(R.cols()).noalias() =
          R.topRows(A.rows()).transpose() * AR;
    }
  } else {
    const Acting few = acting(A, std::move(dofs));
    const MatrixXd rows = few.rows_of(R);
    const MatrixXd AR = symmetric_product(few.A, rows);
    both << few.rows_of(V).transpose() * AR, rows.transpose() * AR;
  }
  return both;
}

MatrixXd seen_through(const MatrixXd& V,
                      const MatrixXd& R,
                      const BorderedMatrix& A) {
  MatrixXd both = seen_through(V, R, A.shared());
  if (A.border().nonZeros() > 0) both += seen_through(V, R, A.border());
  return both;
}

MatrixXd seen_through_all(const MatrixXd& V,
                          const MatrixXd& R,
                          const SparseMatrix& A) {
  const Acting few = acting(A);
  MatrixXd rows(few.A.rows(), V.cols() + R.cols());
  rows << few.rows_of(V), few.rows_of(R);
  return rows.transpose() * symmetric_product(few.A, rows);
}

}  // namespace tapfit::structure
