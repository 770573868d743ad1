// Bordered matrices against the same in one piece.
#include "updating/structure/solve/bordered_matrix.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

SparseMatrix symmetric(Index n, Index from) {
  MatrixXd A = MatrixXd::Zero(n, n);
  const Index count = n - from;
  const MatrixXd B = MatrixXd::Random(count, count);
  A.bottomRightCorner(count, count) = B + B.transpose();
  return A.sparseView();
}

TEST(BorderedMatrix, IsItsPartsInOnePiece) {
  const SparseMatrix shared = symmetric(7, 0);
  const SparseMatrix first = symmetric(9, 5);
  const SparseMatrix second = symmetric(10, 3);
  BorderedMatrix A = shared;
  EXPECT_EQ(A.rows(), 7);
  EXPECT_EQ((A.whole() - shared).norm(), 0.0);
  A.add(first);
  A.add(second);
  MatrixXd dense = second;
  dense.topLeftCorner(9, 9) += MatrixXd(first);
  dense.topLeftCorner(7, 7) += MatrixXd(shared);
  ASSERT_EQ(A.rows(), 10);
  EXPECT_EQ((MatrixXd(A.whole()) - dense).norm(), 0.0);
  for (Index k = 0; k < 10; ++k) EXPECT_EQ(A.diagonal(k), dense(k, k)) << k;
  const MatrixXd X = MatrixXd::Random(10, 11);
  EXPECT_LT((symmetric_product(A, X) - dense * X).norm(), 1e-13);
  const SparseMatrix few = symmetric(10, 6);
  EXPECT_LT((MatrixXd(A.times(few)) - dense * few).norm(), 1e-13);
}

TEST(BorderedMatrix, OfNothingIsNothing) {
  const SparseMatrix none(4, 4);
  EXPECT_TRUE(BorderedMatrix().is_zero());
  BorderedMatrix A = none;
  EXPECT_TRUE(A.is_zero());
  A.add(symmetric(4, 2));
  EXPECT_FALSE(A.is_zero());
}

}  // namespace
}  // namespace tapfit::structure
