// Extended bases against the definition: matrices between their own vectors.
#include "updating/reduction/extended_base.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/reduction/subspace.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using structure::SparseMatrix;

constexpr Index model_dofs = 30;

// B' B of random rows on some degrees of freedom.
SparseMatrix random_elements(Index first, Index count) {
  const MatrixXd B = MatrixXd::Random(count + 2, count);
  MatrixXd A = MatrixXd::Zero(model_dofs, model_dofs);
  A.block(first, first, count, count) = B.transpose() * B;
  return A.sparseView();
}

// Vectors of the model with nothing added, their K diagonal, and two parts: one
// of stiffness, one of mass.
class ExtendedBase : public ::testing::Test {
 protected:
  ExtendedBase() {
    M_.setIdentity();
    M_ += random_elements(0, 8);
    const SparseMatrix none(model_dofs, model_dofs);
    parts_ = {{{1, 0}, random_elements(0, 25), none},
              {{0, 1}, none, random_elements(4, 20)}};
    released_.K = K_;
    released_.M = M_;
    for (const UncertainPart& part : parts_) {
      released_.parts.push_back({&part, part.K, part.M});
    }
    V_ = orthonormalise(M_, MatrixXd::Random(model_dofs, 5), 1e-10);
    const MatrixXd reduced = V_.transpose() * (K_ * V_);
    V_ *= Eigen::SelfAdjointEigenSolver<MatrixXd>(reduced).eigenvectors();
    fixed_.rows = PointRows(V_);
    fixed_.K = V_.transpose() * (K_ * V_);
    for (const UncertainPart& part : parts_) {
      fixed_.part_power.push_back(part.power);
      fixed_.K_part.push_back(V_.transpose() * (part.K * V_));
      fixed_.M_part.push_back(V_.transpose() * (part.M * V_));
    }
  }

  ReducedBase extended() const {
    return extended_base(
        V_, fixed_, MatrixXd::Random(model_dofs, 3), released_, {});
  }

  // Rows of what is new are of single precision, 2^-24.
  static constexpr double rounded = 1e-7;

  // How far a reduced matrix is off what it stands for.
  static double off(const MatrixXd& reduced,
                    const MatrixXd& W,
                    const SparseMatrix& A) {
    const MatrixXd AW = A * W;
    return (reduced - W.transpose() * AW).norm() / (1.0 + A.norm());
  }

  void expect_seen_through_own_vectors(const ReducedBase& base) const {
    const MatrixXd W = base.rows.all();
    const Index n = 8 - static_cast<Index>(released_.held.size());
    ASSERT_EQ(W.cols(), n);
    EXPECT_LT(off(MatrixXd::Identity(n, n), W, M_), rounded);
    EXPECT_LT(off(base.K, W, K_), rounded);
    for (std::size_t k = 0; k < 2; ++k) {
      const UncertainPart& part = parts_[k];
      EXPECT_LT(off(base.K_part[k], W, part.K), rounded);
      EXPECT_LT(off(base.M_part[k], W, part.M), rounded);
    }
  }

  // A change of stiffness and mass, one of its parts of stiffness alone.
  void expect_terms_of_a_change() {
    const SparseMatrix none(model_dofs, model_dofs);
    released_.scaled.push_back({0,
                                1,
                                random_elements(10, 4),
                                {{{1, 0}, random_elements(10, 4), none}},
                                {random_elements(11, 5),
                                 random_elements(12, 3),
                                 {{{1, 0}, random_elements(9, 4), none}}}});
    const ScaledStiffness& scaled = released_.scaled.front();
    const ReducedBase base = extended();
    expect_seen_through_own_vectors(base);
    const MatrixXd W = base.rows.all();
    for (const int dof : released_.held) {
      EXPECT_TRUE(base.rows.row(dof).isZero(0.0)) << dof;
    }
    ASSERT_EQ(base.terms.size(), 1U);
    const StiffnessTerm& term = base.terms.front();
    EXPECT_EQ(term.parameter, 1U);
    EXPECT_LT(off(term.S, W, scaled.S), rounded);
    EXPECT_LT(off(term.T, W, scaled.thickness.K), rounded);
    EXPECT_LT(off(term.N, W, scaled.thickness.M), rounded);
    EXPECT_LT(off(term.S_part[0], W, scaled.parts[0].K), rounded);
    EXPECT_LT(off(term.T_part[0], W, scaled.thickness.parts[0].K), rounded);
    EXPECT_TRUE(term.N_part[0].isZero(0.0));
  }

  SparseMatrix K_ = random_elements(0, model_dofs);
  SparseMatrix M_{model_dofs, model_dofs};
  std::vector<UncertainPart> parts_;
  ReleasedSystem released_;
  MatrixXd V_;
  ReducedBase fixed_;
};

TEST_F(ExtendedBase, IsTurnedToItsModesWhereNothingChanges) {
  const ReducedBase base = extended();
  expect_seen_through_own_vectors(base);
  MatrixXd beside = base.K;
  beside.diagonal().setZero();
  EXPECT_LT(beside.norm(), 1e-13 * base.K.norm());
}

TEST_F(ExtendedBase, HoldsTheTermsOfAChange) { expect_terms_of_a_change(); }

TEST_F(ExtendedBase, LeavesWhatIsHeldAtRest) {
  released_.held = {3, 11};
  expect_terms_of_a_change();
}

TEST_F(ExtendedBase, IsNothingWhereNothingIsLeftToMove) {
  for (int dof = 0; dof < model_dofs; ++dof) released_.held.push_back(dof);
  EXPECT_THROW(static_cast<void>(extended()), InputError);
}

}  // namespace
}  // namespace tapfit::updating
