#include "updating/structure/solve/symmetric_product.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Full near the diagonal and at its far corners, nothing in rows 20 to 24.
SparseMatrix banded() {
  constexpr int n = 60;
  std::vector<Eigen::Triplet<double>> entries;
  const auto idle = [](int i) { return i >= 20 && i < 25; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int apart = std::abs(i - j);
      if (idle(i) || idle(j) || (apart > 4 && apart < n - 3)) continue;
      entries.emplace_back(i, j, std::cos(i + j) / (1.0 + apart));
    }
  }
  SparseMatrix A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

// Eigen's own product, around every multiple of what is taken at a time.
TEST(SymmetricProduct, IsTheProductForAnyNumberOfColumns) {
  const SparseMatrix A = banded();
  for (const Index columns : {0, 1, 2, 7, 8, 9, 15, 16, 21}) {
    const MatrixXd X = MatrixXd::Random(A.rows(), columns);
    const MatrixXd expected = A * X;
    const MatrixXd found = symmetric_product(A, X);
    ASSERT_EQ(found.rows(), A.rows());
    ASSERT_EQ(found.cols(), columns);
    // Sums of some ten products of numbers up to 1.
    EXPECT_LE((found - expected).norm(), 1e-14 * expected.norm()) << columns;
  }
}

TEST(SymmetricProduct, TakesRowsOfATallerMatrix) {
  const SparseMatrix A = banded();
  const MatrixXd tall = MatrixXd::Random(A.rows() + 5, 10);
  const MatrixXd expected = A * MatrixXd(tall.topRows(A.rows()));
  EXPECT_LE((symmetric_product(A, tall.topRows(A.rows())) - expected).norm(),
            1e-14 * expected.norm());
}

}  // namespace
}  // namespace tapfit::structure
