#include "updating/reduction/subspace.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;

MatrixXd orthonormalise(const SparseMatrix& M, MatrixXd V, double least) {
  // A vector that is nothing (a patch that no mode strains) has no direction.
  std::vector<Index> moving;
  const MatrixXd MV = structure::product(M, V);
  for (Index k = 0; k < V.cols(); ++k) {
    const double norm = std::sqrt(V.col(k).dot(MV.col(k)));
    if (!(norm > 0.0)) continue;
    V.col(k) /= norm;
    moving.push_back(k);
  }
  V = MatrixXd(V(Eigen::all, moving));
  if (moving.empty()) return V;
  // Twice, because a residual vector nearly inside the modes' span loses
  // digits the first time.
  for (int pass = 0; pass < 2; ++pass) {
    const MatrixXd gram = V.transpose() * structure::product(M, V);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(gram);
    const VectorXd& d = solver.eigenvalues();
    const double limit = least * d.maxCoeff();
    Index first = 0;
    while (d(first) < limit) ++first;
    const Index kept = d.size() - first;
    const MatrixXd Q = solver.eigenvectors().rightCols(kept);
    const VectorXd scale = d.tail(kept).cwiseSqrt().cwiseInverse();
    V = (V * Q * scale.asDiagonal()).eval();
  }
  return V;
}

MatrixXd join(const std::vector<MatrixXd>& blocks) {
  Index columns = 0;
  for (const MatrixXd& block : blocks) columns += block.cols();
  MatrixXd V(blocks.front().rows(), columns);
  Index at = 0;
  for (const MatrixXd& block : blocks) {
    V.middleCols(at, block.cols()) = block;
    at += block.cols();
  }
  return V;
}

MatrixXd beyond(const SparseMatrix& M,
                const MatrixXd& V,
                const MatrixXd& columns) {
  MatrixXd R = columns;
  const Index n = V.rows();  // the released degrees of freedom follow
  for (int pass = 0; pass < 2; ++pass) {
    const MatrixXd MR = structure::product(M, R).topRows(n);
    R.topRows(n) -= V * (V.transpose() * MR);
  }
  // What is left of a vector that V holds already is rounding.
  std::vector<Index> kept;
  for (Index k = 0; k < R.cols(); ++k) {
    if (R.col(k).norm() > 1e-8 * columns.col(k).norm()) kept.push_back(k);
  }
  return orthonormalise(M, MatrixXd(R(Eigen::all, kept)), 1e-12);
}

}  // namespace tapfit::updating
