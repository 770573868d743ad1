#include "updating/structure/solve/symmetric_product.hpp"

#include <algorithm>
#include <cassert>

namespace tapfit::structure {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd symmetric_product(const SparseMatrix& A,
                           const Eigen::Ref<const MatrixXd>& X) {
  assert(A.rows() == A.cols() && A.cols() == X.rows());
  if (X.cols() == 1) return A * X;
  constexpr int width = 8;  // two registers of four, or four of two
  Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor> x;
  x.setZero(X.rows(), width);
  MatrixXd Y(X.rows(), X.cols());
  for (Index first = 0; first < X.cols(); first += width) {
    const Index count = std::min<Index>(width, X.cols() - first);
    x.leftCols(count) = X.middleCols(first, count);
    for (Index i = 0; i < A.cols(); ++i) {
      Eigen::Matrix<double, 1, width> sum;
      sum.setZero();
      for (SparseMatrix::InnerIterator at(A, i); at; ++at) {
        sum += at.value() * x.row(at.row());
      }
      Y.row(i).segment(first, count) = sum.head(count);
    }
  }
  return Y;
}

}  // namespace tapfit::structure
