#include "updating/reduction/changed_motions.hpp"

#include "updating/reduction/subspace.hpp"
#include "updating/structure/solve/factor.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;

// A unit of each degree of freedom that is released: dofs x count.
MatrixXd unit_motions(const HeldBase& base, const ReleasedSystem& released) {
  std::vector<int> loose;
  std::set_difference(released.active.begin(),
                      released.active.end(),
                      base.motions.free.begin(),
                      base.motions.free.end(),
                      std::back_inserter(loose));
  const Index n = base.system.dofs();
  // The system's own come first; what follows a rigid element goes with them.
  const auto joints =
      std::lower_bound(loose.begin(), loose.end(), static_cast<int>(n));
  const structure::FreeMotions supports =
      structure::free_motions(base.system.T, {loose.begin(), joints}, n);
  MatrixXd unit =
      MatrixXd::Zero(released.dofs(), static_cast<Index>(loose.size()));
  unit.topLeftCorner(n, supports.size()) =
      supports.expand(MatrixXd::Identity(supports.size(), supports.size()));
  for (auto q = joints; q != loose.end(); ++q) {
    unit(*q, q - loose.begin()) = 1.0;
  }
  return unit;
}

// How much of each vector of V the band moves: those of modes in it fully.
VectorXd shares(const HeldBase& base) {
  const double top = std::pow(2.0 * std::numbers::pi * base.high_hz, 2);
  return (top / base.K.array().cwiseMax(top)).matrix();
}

// Columns of X turned so that X' N X is diagonal, largest first; those below
// `least` of the largest, in the square root, are dropped.
// @param gram X' N X
MatrixXd leading(const MatrixXd& X, const MatrixXd& gram, double least) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(gram);
  const VectorXd& d = solver.eigenvalues();
  const Index kept =
      (d.array() > least * least * std::max(d.maxCoeff(), 0.0)).count();
  return X * solver.eigenvectors().rightCols(kept).rowwise().reverse();
}

// What of q inertia drives most, from rigid springs (where q is as the force on
// them) to none: the columns of Q.
MatrixXd driven(const HeldBase& base,
                const ReleasedSystem& released,
                const MatrixXd& psi) {
  constexpr double least = 1e-2;
  const MatrixXd Mpsi = structure::product(released.M, psi);
  const MatrixXd K = psi.transpose() *
                     (structure::product(released.K, psi) + base.shift * Mpsi);
  const MatrixXd forces = Mpsi.topRows(base.V.rows()).transpose() * base.V *
                          shares(base).asDiagonal();
  const MatrixXd soft = K.ldlt().solve(forces);
  MatrixXd both(soft.rows(), 2 * soft.cols());
  both << soft / std::max(soft.norm(), 1e-300),
      forces / std::max(forces.norm(), 1e-300);
  const Eigen::HouseholderQR<MatrixXd> qr(
      leading(both, both.transpose() * both, least));
  const Index columns = std::min(qr.matrixQR().rows(), qr.matrixQR().cols());
  return qr.householderQ() * MatrixXd::Identity(soft.rows(), columns);
}

}  // namespace

MatrixXd constraint_modes(const HeldBase& base,
                          const ReleasedSystem& released) {
  const Index n = base.system.dofs();
  MatrixXd psi = unit_motions(base, released);
  if (psi.cols() == 0) return psi;
  const MatrixXd forces = structure::product(released.K, psi) +
                          base.shift * structure::product(released.M, psi);
  psi.topRows(n) -= base.answers.to(forces.topRows(n));
  const MatrixXd lead = psi * driven(base, released, psi);
  MatrixXd inertia = MatrixXd::Zero(released.dofs(), lead.cols());
  inertia.topRows(n) =
      base.answers.to(structure::product(released.M, lead).topRows(n));
  return join({psi, inertia});
}

MatrixXd answers_to(const HeldBase& base,
                    const SparseMatrix& soft,
                    const MatrixXd& forces) {
  if (forces.cols() == 0) return forces;
  const structure::Factor factor(
      base.motions.reduce(soft + base.shift * base.system.M));
  return orthonormalise(
      base.system.M,
      join({base.answers.to(forces),
            base.motions.expand(factor.solve(base.motions.project(forces)))}),
      1e-10);
}

// Of the energy in the elements.
constexpr double little = 3e-2;

// u = V a + (1 - p) (A - (1 - p) S)^-1 S V a: patterns of the elements' own
// forces are few, and between its two ends the answer to one runs smoothly.
MatrixXd loss_modes(const HeldBase& base, const SparseMatrix& S, double least) {
  const MatrixXd U = base.V * shares(base).asDiagonal();
  const MatrixXd SU = S * U;
  return answers_to(base,
                    base.system.K - (1.0 - least) * S,
                    leading(SU, U.transpose() * SU, little));
}

MatrixXd added_modes(const HeldBase& base, const SparseMatrix& S, double most) {
  const MatrixXd U = base.V * shares(base).asDiagonal();
  const MatrixXd SU = S * U;
  const MatrixXd energy = U.transpose() * SU;
  const double sign = energy.trace() < 0.0 ? -1.0 : 1.0;
  return answers_to(
      base, base.system.K + most * S, leading(SU, sign * energy, little));
}

MatrixXd thinned_modes(const HeldBase& base,
                       const SparseMatrix& S,
                       const SparseMatrix& N,
                       double least) {
  const MatrixXd U = base.V * shares(base).asDiagonal();
  const MatrixXd NU = N * U;
  return answers_to(base,
                    base.system.K - (1.0 - least) * S,
                    leading(NU, U.transpose() * NU, little));
}

}  // namespace tapfit::updating
