#include "updating/mesh_shift.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// MAC from which modes of two meshes are the same one.
constexpr double same_mode = 0.5;

// A larger change of shape is a turn among close modes, or of a mode that the
// coarser mesh hardly has: the first order says nothing of it.
constexpr double largest_change = 0.15;

// Of the modal mass in all: with twice as much taken off or added (f of
// mesh_factors() from 0.4 to 2.7) it must stay positive.
constexpr double largest_mass = 0.4;

// Shapes that the common grids cannot tell apart are left out by it.
constexpr double ridge = 1e-2;

// Of every grid.
MatrixXd translations(const MatrixXd& rows) {
  MatrixXd result(rows.rows() / 2, rows.cols());
  for (Index g = 0; 6 * g < rows.rows(); ++g) {
    result.middleRows(3 * g, 3) = rows.middleRows(6 * g, 3);
  }
  return result;
}

VectorXd squares(const VectorXd& hz) {
  return (2.0 * std::numbers::pi * hz).cwiseAbs2();
}

}  // namespace

MeshShift mesh_shift(const MeshModes& finer, const MeshModes& coarser) {
  const Index n = finer.hz.size();
  MeshShift shift{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
  if (coarser.hz.size() == 0) return shift;
  const MatrixXd fine = translations(finer.rows);
  const MatrixXd coarse = translations(coarser.rows);
  const VectorXd length = fine.colwise().norm().cwiseMax(1e-300);
  const MatrixXd unit = fine * length.cwiseInverse().asDiagonal();
  const MatrixXd overlap = unit.transpose() * coarse.colwise().normalized();
  const VectorXd l = squares(finer.hz);
  const VectorXd l_coarse = squares(coarser.hz);
  MatrixXd gain = MatrixXd::Zero(fine.rows(), n);
  for (Index r = 0; r < n; ++r) {
    Index like = 0;
    if (overlap.row(r).cwiseAbs2().maxCoeff(&like) < same_mode) continue;
    shift.K(r, r) = l(r) - l_coarse(like);
    gain.col(r) =
        fine.col(r) - std::copysign(1.0, overlap(r, like)) * coarse.col(like);
  }
  MatrixXd normal = unit.transpose() * unit;
  normal.diagonal().array() += ridge;
  MatrixXd T = length.cwiseInverse().asDiagonal() *
               normal.llt().solve(unit.transpose() * gain);
  for (Index r = 0; r < n; ++r) {
    if (T.col(r).norm() > largest_change) T.col(r).setZero();
  }
  shift.M = -(T + T.transpose());
  if (shift.M.selfadjointView<Eigen::Lower>().operatorNorm() > largest_mass) {
    shift.M.setZero();
    return shift;
  }
  shift.K -= T.transpose() * l.asDiagonal();
  shift.K -= l.asDiagonal() * T;
  return shift;
}

}  // namespace tapfit::updating
