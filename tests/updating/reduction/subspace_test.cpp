// Spans against the definition: products in M.
#include "updating/reduction/subspace.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using structure::SparseMatrix;

// Of a bar in equal pieces.
SparseMatrix bar_mass(Index n) {
  SparseMatrix M(n, n);
  for (Index i = 0; i < n; ++i) {
    M.insert(i, i) = 4.0;
    if (i > 0) M.insert(i, i - 1) = M.insert(i - 1, i) = 1.0;
  }
  M.makeCompressed();
  return M;
}

double off_unit(const MatrixXd& V, const SparseMatrix& M) {
  const MatrixXd gram = V.transpose() * (M * V);
  return (gram - MatrixXd::Identity(V.cols(), V.cols())).norm();
}

TEST(Subspace, IsOrthonormalWithoutWhatIsRepeated) {
  const SparseMatrix M = bar_mass(40);
  const MatrixXd two = MatrixXd::Random(40, 2);
  MatrixXd columns(40, 5);
  columns << two.col(0), 1e6 * two.col(0), 0.0 * two.col(0), two;
  const MatrixXd V = orthonormalise(M, columns, 1e-10);
  ASSERT_EQ(V.cols(), 2);
  EXPECT_LT(off_unit(V, M), 1e-13);
  EXPECT_LT((two - V * (V.transpose() * (M * two))).norm(), 1e-12);
  EXPECT_EQ(orthonormalise(M, MatrixXd::Zero(40, 3), 1e-10).cols(), 0);
}

// Five degrees of freedom are released behind the base. Of four vectors one is
// nearly in its span, one is, and one is nothing.
TEST(Subspace, IsWhatVectorsHaveBeyondABase) {
  constexpr Index n = 40;
  const SparseMatrix M = bar_mass(n + 5);
  const structure::SparseMatrix own = bar_mass(n);
  const MatrixXd V = orthonormalise(own, MatrixXd::Random(n, 6), 0.0);
  const MatrixXd inside = V * MatrixXd::Random(6, 2);
  MatrixXd columns = MatrixXd::Zero(n + 5, 4);
  columns.leftCols(2).setRandom();
  columns.col(1) *= 1e-6;
  columns.topRows(n).middleCols(1, 2) += inside;
  const MatrixXd R = m_orthogonal_complement(M, V, columns);
  ASSERT_EQ(R.cols(), 2);
  MatrixXd whole = MatrixXd::Zero(n + 5, 8);
  whole.topLeftCorner(n, 6) = V;
  whole.rightCols(2) = R;
  // To rounding, though six digits of the second vector are the base's.
  EXPECT_LT(off_unit(whole, M), 1e-12);
  const MatrixXd left = columns - whole * (whole.transpose() * (M * columns));
  EXPECT_LT(left.norm(), 1e-13 * columns.norm());
}

TEST(Subspace, ShorterBlocksAreZeroBelow) {
  const MatrixXd tall = MatrixXd::Random(5, 2);
  const MatrixXd low = MatrixXd::Random(3, 1);
  MatrixXd expected = MatrixXd::Zero(5, 3);
  expected.leftCols(2) = tall;
  expected.topRightCorner(3, 1) = low;
  EXPECT_EQ(join({tall, low}), expected);
  EXPECT_EQ(join({MatrixXd(3, 0), tall}), tall);
}

}  // namespace
}  // namespace tapfit::updating
