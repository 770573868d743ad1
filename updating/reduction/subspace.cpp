#include "updating/reduction/subspace.hpp"

#include "updating/structure/solve/symmetric_product.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::BorderedMatrix;
using structure::symmetric_product;

namespace {

// W with W' G W = I for the vectors' products G = V' M V: V W is orthonormal.
// A vector that is nothing (a patch that no mode strains) has no direction.
MatrixXd made_orthonormal(const MatrixXd& gram, double least) {
  const VectorXd unit = gram.diagonal().unaryExpr([](double square) {
    return square > 0.0 ? 1.0 / std::sqrt(square) : 0.0;
  });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      MatrixXd(unit.asDiagonal() * gram * unit.asDiagonal()));
  const VectorXd& d = solver.eigenvalues();
  const Index kept = (d.array() > least * std::max(d.maxCoeff(), 0.0)).count();
  return unit.asDiagonal() * solver.eigenvectors().rightCols(kept) *
         d.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

// @param MV M V
MatrixXd orthonormal(const BorderedMatrix& M,
                     MatrixXd V,
                     const MatrixXd& MV,
                     double least) {
  if (V.cols() == 0) return V;
  V = (V * made_orthonormal(V.transpose() * MV, least)).eval();
  if (V.cols() == 0) return V;
  // Again, because a residual vector nearly inside the modes' span loses digits
  // the first time.
  const MatrixXd gram = V.transpose() * symmetric_product(M, V);
  return V * made_orthonormal(gram, least);
}

}  // namespace

MatrixXd orthonormalise(const BorderedMatrix& M, MatrixXd V, double least) {
  const MatrixXd MV = symmetric_product(M, V);
  return orthonormal(M, std::move(V), MV, least);
}

MatrixXd join(std::vector<MatrixXd> blocks) {
  Index rows = 0;
  Index columns = 0;
  for (const MatrixXd& block : blocks) {
    rows = std::max(rows, block.rows());
    columns += block.cols();
  }
  for (MatrixXd& block : blocks) {
    const bool alone = block.rows() == rows && block.cols() == columns;
    if (alone) return std::move(block);
  }
  MatrixXd V(rows, columns);
  Index at = 0;
  for (const MatrixXd& block : blocks) {
    V.middleCols(at, block.cols()).topRows(block.rows()) = block;
    V.middleCols(at, block.cols()).bottomRows(rows - block.rows()).setZero();
    at += block.cols();
  }
  return V;
}

MatrixXd m_orthogonal_complement(const BorderedMatrix& M,
                                 const MatrixXd& V,
                                 MatrixXd columns) {
  MatrixXd& R = columns;
  const VectorXd whole = R.colwise().norm();
  const Index n = V.rows();  // the released degrees of freedom follow
  MatrixXd MR;
  // Twice is enough where a column keeps some of its digits; of answers that
  // are nearly all rigid motion the mass that is left is a smaller share.
  for (int pass = 0; pass < 3; ++pass) {
    MR = symmetric_product(M, R);
    R.topRows(n).noalias() -= V * (V.transpose() * MR.topRows(n));
  }
  // What is left of a vector that V holds already is rounding.
  std::vector<Index> kept;
  for (Index k = 0; k < R.cols(); ++k) {
    if (R.col(k).norm() > 1e-8 * whole(k)) kept.push_back(k);
  }
  if (static_cast<Index>(kept.size()) < R.cols()) {
    R = MatrixXd(R(Eigen::all, kept));
  }
  // Down to rounding: what turns grids that have next to no mass is a small
  // share of all columns, and yet a mode may hang on it.
  MR = symmetric_product(M, R);
  return orthonormal(M, std::move(R), MR, 1e-14);
}

}  // namespace tapfit::updating
