#include "updating/reduction/held_motions.hpp"

#include "updating/reduction/subspace.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the energy of the forces by which the band's modes are held, in the square
// root.
constexpr double least_pattern = 1e-3;

// Of the largest: what rounding leaves of forces that have been told already.
constexpr double told = 1e-12;

// Of rows of length one: what moves them less is as good as held.
constexpr double next_to_none = 1e-9;

// Of the longest row: rounding in the place of what cannot move. Turns and
// displacements are some hundreds or thousands of each other.
constexpr double at_rest = 1e-12;

double top_square(const HeldBase& base) {
  return std::pow(2.0 * M_PI * base.high_hz, 2);
}

// By how much of each vector the band's modes move.
VectorXd shares_in_band(const HeldBase& base) {
  const double top = top_square(base);
  return (top / base.K.array().cwiseMax(top)).matrix();
}

// F - M V_1 V_1' F.
MatrixXd beside_modes(const HeldBase& base, MatrixXd forces) {
  std::vector<Index> soft;
  for (Index k = 0; k < base.V.cols(); ++k) {
    if (base.K(k) < top_square(base)) soft.push_back(k);
  }
  const MatrixXd V = base.V(Eigen::all, soft);
  forces.noalias() -= base.system.M * (V * (V.transpose() * forces));
  return forces;
}

}  // namespace

MatrixXd held_modes(const HeldBase& base, const std::vector<int>& dofs) {
  const MatrixXd psi = base.answers.to_points(dofs, 1);
  // Those that move, each by as much as a unit force on it does.
  std::vector<int> moving;
  for (const int dof : dofs) {
    if (!psi.row(dof).isZero(0.0)) moving.push_back(dof);
  }
  if (moving.empty() || psi.cols() == 0) return psi;
  const MatrixXd G = psi(moving, Eigen::all);
  const MatrixXd wanted =
      base.V(moving, Eigen::all) * shares_in_band(base).asDiagonal();
  // psi F moves what is held as the modes do: F = G^-1 E' V, as far as G tells
  // forces apart.
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(told);
  solver.compute(G);
  const MatrixXd F = solver.solve(wanted);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> energy(wanted.transpose() * F);
  const VectorXd& e = energy.eigenvalues();
  const Index kept =
      (e.array() > least_pattern * least_pattern * e.maxCoeff()).count();
  const MatrixXd lead = psi * (F * energy.eigenvectors().rightCols(kept));
  MatrixXd forces = MatrixXd::Zero(base.V.rows(), std::ssize(moving));
  for (std::size_t k = 0; k < moving.size(); ++k) {
    forces(moving[k], static_cast<Index>(k)) = 1.0;
  }
  return join(
      {base.answers.to(beside_modes(base, forces)),
       base.answers.to(beside_modes(base, MatrixXd(base.system.M * lead)))});
}

MatrixXd motions_without(const MatrixXd& rows) {
  const VectorXd length = rows.rowwise().norm();
  std::vector<Index> moving;
  for (Index k = 0; k < rows.rows(); ++k) {
    if (length(k) > at_rest * length.maxCoeff()) moving.push_back(k);
  }
  if (moving.empty()) return MatrixXd::Identity(rows.cols(), rows.cols());
  const MatrixXd unit = rows(moving, Eigen::all).rowwise().normalized();
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  qr.setThreshold(next_to_none);
  qr.compute(unit.transpose());
  const MatrixXd Q =
      qr.householderQ() * MatrixXd::Identity(rows.cols(), rows.cols());
  return Q.rightCols(rows.cols() - qr.rank());
}

}  // namespace tapfit::updating
