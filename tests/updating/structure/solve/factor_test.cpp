#include "updating/structure/solve/factor.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// n masses in a row between two walls, joined by springs of 1 N/m.
SparseMatrix row_of_springs(Index n) {
  SparseMatrix K(n, n);
  for (Index i = 0; i < n; ++i) {
    K.insert(i, i) = 2.0;
    if (i > 0) K.insert(i, i - 1) = K.insert(i - 1, i) = -1.0;
  }
  K.makeCompressed();
  return K;
}

// Closed form: a unit force at k pulls the row into two straight lines,
// u_i = (min + 1) (n - max) / (n + 1), of i and k.
VectorXd pulled_at(Index k, Index n) {
  VectorXd u(n);
  for (Index i = 0; i < n; ++i) {
    const auto low = static_cast<double>(std::min(i, k) + 1);
    const auto high = static_cast<double>(n - std::max(i, k));
    u(i) = low * high / static_cast<double>(n + 1);
  }
  return u;
}

// Bases for several effects are built at once and ask one factor.
TEST(Factor, AnswersOnSeveralThreadsAtOnce) {
  constexpr Index n = 200;
  const Factor factor(row_of_springs(n));
  std::vector<double> error(static_cast<std::size_t>(n));
  for_each_parallel(error.size(), [&](std::size_t at) {
    const auto k = static_cast<Index>(at);
    const VectorXd u = factor.solve(VectorXd::Unit(n, k));
    error[at] = (u - pulled_at(k, n)).lpNorm<Eigen::Infinity>();
  });
  // The condition number is 4 (n / pi)^2, 16 000, and u at most 50.
  EXPECT_LT(*std::ranges::max_element(error), 1e-9);
}

// A plate of n x n masses, each joined to its four neighbours and to the
// ground.
SparseMatrix grid_of_springs(int n) {
  std::vector<Eigen::Triplet<double>> all;
  const auto at = [n](int i, int j) { return i * n + j; };
  const auto join = [&all](int a, int b) {
    all.emplace_back(a, a, 1.0);
    all.emplace_back(b, b, 1.0);
    all.emplace_back(a, b, -1.0);
    all.emplace_back(b, a, -1.0);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      all.emplace_back(at(i, j), at(i, j), 0.1);
      if (i > 0) join(at(i, j), at(i - 1, j));
      if (j > 0) join(at(i, j), at(i, j - 1));
    }
  }
  SparseMatrix K(n * n, n * n);
  K.setFromTriplets(all.begin(), all.end());
  return K;
}

// Supernodes of some tens of columns go to the BLAS, which may not be safe for
// several threads: see blas_turn.hpp.
TEST(Factor, FactorsOnSeveralThreadsAtOnce) {
  constexpr int n = 120;
  const SparseMatrix K = grid_of_springs(n);
  const Eigen::MatrixXd B = Eigen::MatrixXd::Identity(K.rows(), 60);
  std::vector<double> left(24);
  for_each_parallel(left.size(), [&](std::size_t at) {
    left[at] = (K * Factor(K).solve(B) - B).lpNorm<Eigen::Infinity>();
  });
  // The condition number is 8.1 / 0.1, and |K| |u| at most some tens.
  EXPECT_LT(*std::ranges::max_element(left), 1e-12);
}

// In an order that is not this matrix's own: any does.
TEST(Factor, AnswersInTheOrderOfAnother) {
  constexpr Index n = 200;
  SparseMatrix ring = row_of_springs(n);
  ring.coeffRef(0, n / 2) = ring.coeffRef(n / 2, 0) = -1e-3;
  const Factor factor(row_of_springs(n), Factor(ring));
  for (const Index k : {Index{0}, n / 3, n - 1}) {
    const VectorXd u = factor.solve(VectorXd::Unit(n, k));
    EXPECT_LT((u - pulled_at(k, n)).lpNorm<Eigen::Infinity>(), 1e-9);
  }
}

TEST(Factor, RefusesAMechanism) {
  SparseMatrix K = row_of_springs(3);
  K.coeffRef(0, 0) = K.coeffRef(2, 2) = 1.0;  // the walls are gone
  EXPECT_THROW(Factor{K}, SingularMatrix);
}

}  // namespace
}  // namespace tapfit::structure
