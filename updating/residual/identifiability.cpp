#include "updating/residual/identifiability.hpp"

#include <Eigen/SVD>

#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// From (S'S)^-1 = V diag(1 / s^2) V' of the scaled columns: scaling does not
// change correlations.
MatrixXd correlations(const MatrixXd& V, const VectorXd& s) {
  const VectorXd weight = s.cwiseMax(1e-14 * s(0)).cwiseAbs2().cwiseInverse();
  const MatrixXd C = V * weight.asDiagonal() * V.transpose();
  const VectorXd sd = C.diagonal().cwiseSqrt();
  return sd.cwiseInverse().asDiagonal() * C * sd.cwiseInverse().asDiagonal();
}

}  // namespace

Identifiability identifiability(const MatrixXd& S, double least) {
  constexpr double takes_part = 0.2;
  Identifiability result;
  const VectorXd norm = S.colwise().norm().transpose();
  const double rounding = 1e-12 * norm.maxCoeff();
  MatrixXd scaled = S;
  for (Index k = 0; k < S.cols(); ++k) {
    if (norm(k) > rounding) {
      scaled.col(k) /= norm(k);
    } else {
      scaled.col(k).setZero();
    }
  }
  const Eigen::JacobiSVD<MatrixXd> svd(scaled, Eigen::ComputeThinV);
  result.singular_values = svd.singularValues();
  result.directions = svd.matrixV();
  result.correlation = correlations(svd.matrixV(), svd.singularValues());
  for (Index k = 0; k < S.cols(); ++k) {
    if (result.singular_values(k) > least * result.singular_values(0)) continue;
    std::vector<Index> group;
    for (Index j = 0; j < S.cols(); ++j) {
      if (std::abs(result.directions(j, k)) > takes_part) group.push_back(j);
    }
    result.confounded.push_back(std::move(group));
  }
  return result;
}

}  // namespace tapfit::updating
