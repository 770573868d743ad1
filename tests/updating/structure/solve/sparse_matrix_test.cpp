#include "updating/structure/solve/sparse_matrix.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

// Every third entry, with rows and columns that are empty; exact, for sums of a
// few small integers are.
TEST(SparseMatrix, ProductIsThatOfTheDenseMatrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(7, 9);
  for (Eigen::Index i = 1; i < 7; ++i) {
    for (Eigen::Index j = 0; j < 8; ++j) {
      if ((i + j) % 3 == 0) dense(i, j) = static_cast<double>(10 * i - j);
    }
  }
  const SparseMatrix A = dense.sparseView();
  for (const Eigen::Index columns : {0, 1, 2, 5, 13}) {
    Eigen::MatrixXd X(9, columns);
    for (Eigen::Index k = 0; k < X.size(); ++k) {
      X(k) = static_cast<double>(k % 11) - 5.0;
    }
    const Eigen::MatrixXd AX = product(A, X);
    ASSERT_EQ(AX.rows(), 7);
    ASSERT_EQ(AX.cols(), columns);
    EXPECT_TRUE((AX.array() == (dense * X).array()).all()) << columns;
  }
}

}  // namespace
}  // namespace tapfit::structure
