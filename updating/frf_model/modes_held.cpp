#include "updating/frf_model/modes_held.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the band, see BaseOptions.
constexpr double modes_reach = 4.0;

// Of the pattern that the band drives most: what it drives less is left free,
// its flexibility lies above the base next to wholly.
constexpr double least_driven = 0.02;

// Of the base's own flexibility, in the place of none above it.
constexpr double next_to_rigid = 1e-6;

// Of the longest row: rounding in the place of what cannot move.
constexpr double cannot_move = 1e-9;

// Each as long as the band moves it: a base ends with motions far above it,
// which turn its grids a lot.
// @param share of each mode in that
MatrixXd rows_that_move(const MatrixXd& rows, const VectorXd& share) {
  const VectorXd length = (rows * share.asDiagonal()).rowwise().norm();
  std::vector<Index> moving;
  for (Index k = 0; k < rows.rows(); ++k) {
    if (length(k) > cannot_move * length.maxCoeff()) moving.push_back(k);
  }
  return length(moving).cwiseInverse().asDiagonal() * rows(moving, Eigen::all);
}

// R for the patterns, from their displacements and rotations in each mode.
MatrixXd flexibility_above(const MatrixXd& moved,
                           const MatrixXd& turned,
                           const VectorXd& omega,
                           double top) {
  const VectorXd weight = omega.unaryExpr([top](double w) {
    return w > top && w <= modes_reach * top ? 1.0 / (w * w) : 0.0;
  });
  const auto sum = [&weight](const MatrixXd& a, const MatrixXd& b, double p) {
    return MatrixXd(a * weight.asDiagonal() * b.transpose() /
                    (std::pow(modes_reach, p) - 1.0));
  };
  const MatrixXd both = sum(moved, turned, 1.0);
  return sum(moved, moved, 1.5) + both + both.transpose() +
         sum(turned, turned, 0.5);
}

}  // namespace

BaseModes modes_held(const BaseModes& modes, const HeldRows& rows, double top) {
  const VectorXd w2 = modes.omega.cwiseAbs2();
  const VectorXd soft = w2.cwiseMax(top * top).cwiseInverse();
  const VectorXd share = top * top * soft;
  const MatrixXd moved = rows_that_move(rows.moved * modes.phi, share);
  const MatrixXd turned = rows_that_move(rows.turned * modes.phi, share);
  if (moved.rows() + turned.rows() == 0) return modes;
  const MatrixXd of_moved = moved.transpose() * moved;
  const MatrixXd of_turned = turned.transpose() * turned;
  // rows diag(share) = U s V': held are the columns of U.
  const MatrixXd by_band =
      share.asDiagonal() * (of_moved + of_turned) * share.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> driven(by_band);
  const VectorXd& s2 = driven.eigenvalues();
  const double least = least_driven * least_driven * s2.maxCoeff();
  const Index count = (s2.array() > least).count();
  const MatrixXd to_patterns =
      s2.tail(count).cwiseSqrt().cwiseInverse().asDiagonal() *
      driven.eigenvectors().rightCols(count).transpose() * share.asDiagonal();
  const MatrixXd P = to_patterns * (of_moved + of_turned);
  const MatrixXd R =
      flexibility_above(
          to_patterns * of_moved, to_patterns * of_turned, modes.omega, top) +
      next_to_rigid * P * soft.asDiagonal() * P.transpose();
  MatrixXd K = P.transpose() * R.ldlt().solve(P);
  K = (0.5 * (K + K.transpose())).eval();
  K.diagonal() += w2;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(K);
  return {solver.eigenvalues().cwiseMax(0.0).cwiseSqrt(),
          modes.phi * solver.eigenvectors()};
}

}  // namespace tapfit::updating
