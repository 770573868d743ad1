#include "updating/structure/solve/bordered_matrix.hpp"

#include "updating/structure/solve/symmetric_product.hpp"

#include <algorithm>

namespace tapfit::structure {

using Eigen::Index;
using Eigen::MatrixXd;

const SparseMatrix& BorderedMatrix::shared() const {
  static const SparseMatrix none;
  return shared_ == nullptr ? none : *shared_;
}

Index BorderedMatrix::rows() const {
  return std::max(shared().rows(), border_.rows());
}

bool BorderedMatrix::is_zero() const {
  return shared().nonZeros() == 0 && border_.nonZeros() == 0;
}

double BorderedMatrix::diagonal(Index k) const {
  const double own = border_.size() > 0 ? border_.coeff(k, k) : 0.0;
  return k < shared().rows() ? shared().coeff(k, k) + own : own;
}

void BorderedMatrix::add(const SparseMatrix& more) {
  border_.conservativeResize(more.rows(), more.cols());
  border_ += more;
}

SparseMatrix BorderedMatrix::times(const SparseMatrix& X) const {
  const SparseMatrix top = X.topRows(shared().rows());
  SparseMatrix Y = shared() * top;
  if (border_.size() == 0) return Y;
  Y.conservativeResize(rows(), X.cols());
  Y += border_ * X;
  return Y;
}

SparseMatrix BorderedMatrix::whole() const {
  SparseMatrix A = shared();
  if (border_.size() == 0) return A;
  A.conservativeResize(rows(), rows());
  return A + border_;
}

MatrixXd symmetric_product(const BorderedMatrix& A,
                           const Eigen::Ref<const MatrixXd>& X) {
  const Index n = A.shared().rows();
  MatrixXd Y = symmetric_product(A.shared(), X.topRows(n));
  if (A.border().size() == 0) return Y;
  MatrixXd all = A.border() * X;
  all.topRows(n) += Y;
  return all;
}

}  // namespace tapfit::structure
