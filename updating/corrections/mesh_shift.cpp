#include "updating/corrections/mesh_shift.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// MAC from which modes of two meshes are the same one.
constexpr double same_mode = 0.5;

// A larger change of shape is a turn among close modes, or of a mode that the
// coarser mesh hardly has.
constexpr double largest_change = 0.3;

// Of the modal mass that may be taken off: with f of corrections() up to 2.7
// what is left must stay positive.
constexpr double largest_mass = 0.5;

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

// Of modes that only move, without bending.
Index rigid_count(const VectorXd& hz) {
  constexpr double still = 1e-4;
  return (hz.array() < still * hz.maxCoeff()).count();
}

// Both meshes move alike as rigid bodies, but each solution has a basis of its
// own: the coarser mesh's turned to where it comes nearest to the other one.
void align_rigid(const MatrixXd& fine, Index rigid, MatrixXd& coarse) {
  const auto some = coarse.leftCols(rigid);
  const MatrixXd turn = some.colPivHouseholderQr().solve(fine.leftCols(rigid));
  const Eigen::JacobiSVD<MatrixXd> svd(
      turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
  coarse.leftCols(rigid) =
      (some * svd.matrixU() * svd.matrixV().transpose()).eval();
}

// A = (I - T)^-1, without the changes of shape beyond `limit`.
MatrixXd inverse_within(MatrixXd T, double limit) {
  for (Index r = 0; r < T.cols(); ++r) {
    if (T.col(r).norm() > limit) T.col(r).setZero();
  }
  const MatrixXd I = MatrixXd::Identity(T.rows(), T.cols());
  return (I - T).householderQr().solve(I);
}

bool leaves_mass(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(A.transpose() * A,
                                                     Eigen::EigenvaluesOnly);
  return gram.eigenvalues().maxCoeff() < 1.0 + largest_mass;
}

// With as many changes of shape as leave a mass, the smallest first.
MatrixXd back_to_coarser(const MatrixXd& T) {
  std::vector<double> limits = {0.0};
  for (Index r = 0; r < T.cols(); ++r) {
    const double norm = T.col(r).norm();
    if (norm > 0.0 && norm < largest_change) limits.push_back(norm);
  }
  std::ranges::sort(limits);
  const auto beyond = std::ranges::partition_point(limits, [&T](double limit) {
    return leaves_mass(inverse_within(T, limit));
  });
  return inverse_within(T, beyond == limits.begin() ? 0.0 : *(beyond - 1));
}

}  // namespace

MeshShift mesh_shift(const MeshModes& finer, const MeshModes& coarser) {
  const Index n = finer.hz.size();
  MeshShift shift{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
  if (coarser.hz.size() == 0) return shift;
  const MatrixXd fine = translations(finer.rows);
  MatrixXd coarse = translations(coarser.rows);
  const Index rigid = rigid_count(finer.hz);
  if (rigid > 0 && rigid == rigid_count(coarser.hz)) {
    align_rigid(fine, rigid, coarse);
  }
  const VectorXd length = fine.colwise().norm().cwiseMax(1e-300);
  const MatrixXd unit = fine * length.cwiseInverse().asDiagonal();
  const MatrixXd overlap = unit.transpose() * coarse.colwise().normalized();
  const VectorXd l = squares(finer.hz);
  const VectorXd l_coarse = squares(coarser.hz);
  VectorXd like = l;
  MatrixXd gain = MatrixXd::Zero(fine.rows(), n);
  for (Index r = 0; r < n; ++r) {
    Index k = 0;
    if (overlap.row(r).cwiseAbs2().maxCoeff(&k) < same_mode) continue;
    like(r) = l_coarse(k);
    gain.col(r) =
        fine.col(r) - std::copysign(1.0, overlap(r, k)) * coarse.col(k);
  }
  MatrixXd normal = unit.transpose() * unit;
  normal.diagonal().array() += ridge;
  const MatrixXd T = length.cwiseInverse().asDiagonal() *
                     normal.llt().solve(unit.transpose() * gain);
  const MatrixXd A = back_to_coarser(T);
  shift.M = MatrixXd::Identity(n, n) - A.transpose() * A;
  shift.K = -(A.transpose() * like.asDiagonal() * A);
  shift.K.diagonal() += l;
  return shift;
}

}  // namespace tapfit::updating
