#include "updating/prediction/form_shift.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Three modes, and what a mass and a spring, both known, make of them.
struct ChangedModes {
  Vector3d omega{10.0, 25.0, 47.0};
  Matrix3d K = Vector3d(omega.cwiseAbs2()).asDiagonal();
  Vector3d at_mass{0.8, -0.5, 0.6};
  Matrix3d M = Matrix3d::Identity() + 0.7 * at_mass * at_mass.transpose();
  Vector3d at_spring{0.3, 0.9, -0.4};
  Matrix3d spring = 200.0 * at_spring * at_spring.transpose();

  using Solver = Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d>;
  [[nodiscard]] Solver after(const Matrix3d& dK) const {
    return Solver(K + dK + spring, M);
  }
  [[nodiscard]] double ln_now(const Matrix3d& dK, Index mode) const {
    const Solver solver(K + dK, Matrix3d::Identity());
    return 0.5 * std::log(solver.eigenvalues()(mode));
  }
  [[nodiscard]] double ln_after(const Matrix3d& dK, Index mode) const {
    return 0.5 * std::log(after(dK).eigenvalues()(mode));
  }
};

// The definition: every e_ij for itself, its slope by differences, and its
// variance, 1 on the diagonal and 1 / 2 beside it.
TEST(FormShift, IsTheSumOverAllEntriesOfTheModalStiffness) {
  const ChangedModes modes;
  const auto solved = modes.after(Matrix3d::Zero());
  for (Index mode = 0; mode < 3; ++mode) {
    FormShift sum{0.0, 0.0, 0.0};
    for (Index i = 0; i < 3; ++i) {
      for (Index j = i; j < 3; ++j) {
        constexpr double step = 1e-5;
        Matrix3d e = Matrix3d::Zero();
        e(i, j) = e(j, i) = step * modes.omega(i) * modes.omega(j);
        const auto slope = [&](const auto& ln) {
          return (ln(e) - ln(Matrix3d(-e))) / (2.0 * step);
        };
        const double now =
            slope([&](const Matrix3d& dK) { return modes.ln_now(dK, mode); });
        const double after =
            slope([&](const Matrix3d& dK) { return modes.ln_after(dK, mode); });
        const double variance = i == j ? 1.0 : 0.5;
        sum.now += variance * now * now;
        sum.after += variance * after * after;
        sum.both += variance * now * after;
      }
    }
    const Vector3d after = solved.eigenvectors().col(mode);
    const FormShift shift = form_shift(
        modes.omega,
        {after, std::sqrt(solved.eigenvalues()(mode)), (modes.M * after)(mode)},
        mode);
    // Central differences of 1e-5: ten digits, less what the roots cost.
    EXPECT_NEAR(0.25 * shift.now, sum.now, 1e-7) << mode;
    EXPECT_NEAR(0.25 * shift.after, sum.after, 1e-7) << mode;
    EXPECT_NEAR(0.25 * shift.both, sum.both, 1e-7) << mode;
  }
}

// A support that gives: what held it was rigid, and strains nothing of the
// deck.
TEST(FormShift, OfASupportThatIsLetGoIsNoMoreThanOfWhatIsStrained) {
  Matrix3d K;
  K << 900.0, -400.0, -50.0, -400.0, 700.0, -300.0, -50.0, -300.0, 500.0;
  const auto held_by = [](double spring) -> Matrix3d {
    return Vector3d(0.0, 0.0, spring).asDiagonal();
  };
  const Eigen::SelfAdjointEigenSolver<Matrix3d> now(K + held_by(1e10));
  const Matrix3d spring = held_by(2000.0);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> after(K + spring);
  const Vector3d omega = now.eigenvalues().cwiseSqrt();
  for (Index mode = 0; mode < 2; ++mode) {
    const Vector3d held = now.eigenvectors().col(mode);
    const Vector3d let_go = after.eigenvectors().col(mode);
    const double w2 = after.eigenvalues()(mode);
    const Vector3d u = now.eigenvectors().transpose() * let_go;
    const FormShift shift =
        form_shift(omega, {u, std::sqrt(w2), u(mode)}, mode);
    // Strained by both, of what the deck's own stiffness says.
    const double strained = let_go.dot(K * let_go) / w2;
    const double both = held.dot(K * let_go);
    EXPECT_NEAR(shift.both, both * both / (held.dot(K * held) * w2), 1e-6);
    EXPECT_LE(shift.both, std::sqrt(shift.after));
    EXPECT_GE(shift.after, strained * strained);
    EXPECT_LE(shift.after, 1.0);
  }
}

TEST(FormShift, OfAModeThatKeepsItsShapeSaysNothingOfItsChange) {
  const Vector3d omega(10.0, 25.0, 47.0);
  // A mass that is felt by this mode alone.
  const double factor = 1.0 / std::sqrt(1.3);
  const FormShift shift = form_shift(
      omega, {Vector3d(0.0, factor, 0.0), 25.0 * factor, 1.0 / factor}, 1);
  EXPECT_NEAR(shift.now + shift.after - 2.0 * shift.both, 0.0, 1e-12);
}

}  // namespace
}  // namespace tapfit::updating
