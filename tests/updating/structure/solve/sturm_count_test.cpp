// The Sturm count against eigenvalues of dense matrices.
#include "updating/structure/solve/sturm_count.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <Eigen/Dense>

#include <random>

namespace tapfit::structure {
namespace {

Eigen::MatrixXd random_symmetric(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd A =
      Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(random); });
  return A + A.transpose();
}

Eigen::Index negative_of(const Eigen::MatrixXd& A) {
  return (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A)
              .eigenvalues()
              .array() < 0.0)
      .count();
}

TEST(SturmCount, IsTheNumberOfNegativeEigenvalues) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    // More columns than one panel holds.
    const Eigen::MatrixXd A = random_symmetric(90, seed);
    EXPECT_EQ(count_negative(sparse(A)), negative_of(A));
    EXPECT_EQ(count_negative(sparse(A * A)), 0);
    EXPECT_EQ(count_negative(sparse(-A * A)), 90);
  }
  EXPECT_EQ(count_negative(SparseMatrix(0, 0)), 0);
}

TEST(SturmCount, GoesThroughManySupernodes) {
  // A plate's stiffness without mass at the rotations, shifted into its modes.
  Deck deck = plate_deck({.b = 0.8, .coupled = false}, 9, 7);
  hold(deck, "123456", [](const Eigen::Vector3d& p) { return p.x() < 1e-9; });
  const System system = assemble(deck);
  const std::vector<int> free = system.free_dofs();
  const SparseMatrix K = extract(system.K, free);
  const SparseMatrix M = extract(system.M, free);
  for (const double hz : {10.0, 100.0, 1000.0, 3000.0}) {
    const double shift = std::pow(2 * M_PI * hz, 2);
    const Eigen::MatrixXd A = K - shift * M;
    EXPECT_EQ(count_below(K, M, shift), negative_of(A)) << hz;
  }
}

TEST(SturmCount, SaysWhenItIsUncertain) {
  EXPECT_FALSE(count_negative(sparse(Eigen::Matrix3d::Zero())).has_value());
  Eigen::Matrix3d chain;  // free: zero is an eigenvalue
  chain << 1, -1, 0, -1, 2, -1, 0, -1, 1;
  EXPECT_FALSE(count_negative(sparse(chain)).has_value());
  Eigen::Matrix2d grows;  // the second pivot is -1e9
  grows << 1e-9, 1, 1, 1;
  EXPECT_FALSE(count_negative(sparse(grows)).has_value());
}

}  // namespace
}  // namespace tapfit::structure
