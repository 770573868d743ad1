#include "updating/structure/solve/seen_through.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Symmetric, on some degrees of freedom of thirty.
SparseMatrix on(const std::vector<int>& dofs, Index size = 30) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const int a : dofs) {
    for (const int b : dofs) entries.emplace_back(a, b, 1.0 / (1.0 + a + b));
  }
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

std::vector<int> first(int count) {
  std::vector<int> dofs;
  for (int k = 0; k < count; ++k) dofs.push_back(k);
  return dofs;
}

TEST(SeenThrough, IsTheProductForFewDofsAndForAll) {
  const MatrixXd V = MatrixXd::Random(30, 5);
  for (const auto& dofs :
       {std::vector<int>{}, std::vector<int>{3, 4, 20}, first(30)}) {
    const SparseMatrix A = on(dofs);
    const MatrixXd expected = V.transpose() * (A * V);
    EXPECT_LT((seen_through(V, A) - expected).norm(), 1e-13);
  }
}

TEST(SeenThrough, HoldsWhatIsReleasedBehindTheBase) {
  const MatrixXd V = MatrixXd::Random(26, 5);
  const MatrixXd R = MatrixXd::Random(30, 3);
  MatrixXd whole = MatrixXd::Zero(30, 8);
  whole.topLeftCorner(26, 5) = V;
  whole.rightCols(3) = R;
  for (const auto& dofs :
       {std::vector<int>{}, std::vector<int>{3, 25, 28}, first(30)}) {
    const SparseMatrix A = on(dofs);
    const MatrixXd expected = whole.transpose() * (A * R);
    EXPECT_LT((seen_through(V, R, A) - expected).norm(), 1e-13);
  }
}

// A matrix of the structure before anything was released.
TEST(SeenThrough, TakesAMatrixThatEndsBeforeTheVectors) {
  const MatrixXd V = MatrixXd::Random(26, 5);
  const MatrixXd R = MatrixXd::Random(30, 3);
  for (const auto& dofs : {std::vector<int>{3, 25}, first(26)}) {
    const SparseMatrix A = on(dofs, 26);
    const MatrixXd AR = A * MatrixXd(R.topRows(26));
    MatrixXd expected(8, 3);
    expected << V.transpose() * AR, R.topRows(26).transpose() * AR;
    EXPECT_LT((seen_through(V, R, A) - expected).norm(), 1e-13);
  }
}

TEST(SeenThrough, IsTheWholeProductOfWhatActsOnFewDofs) {
  const MatrixXd V = MatrixXd::Random(26, 5);
  const MatrixXd R = MatrixXd::Random(30, 3);
  MatrixXd whole = MatrixXd::Zero(30, 8);
  whole.topLeftCorner(26, 5) = V;
  whole.rightCols(3) = R;
  for (const auto& dofs : {std::vector<int>{}, std::vector<int>{3, 25, 28}}) {
    const SparseMatrix A = on(dofs);
    const MatrixXd expected = whole.transpose() * (A * whole);
    EXPECT_LT((seen_through_all(V, R, A) - expected).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace tapfit::structure
