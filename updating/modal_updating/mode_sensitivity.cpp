#include "updating/modal_updating/mode_sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;

VectorXd eigenvalues(const structure::Eigenmodes& modes) {
  return (2.0 * std::numbers::pi * modes.frequency_hz).cwiseAbs2();
}

// s = the highest eigenvalue known: K + s M is positive definite, also of a
// free structure, and near enough to K - lambda M above the known modes.
SparseMatrix shifted(const SparseMatrix& K,
                     const SparseMatrix& M,
                     const VectorXd& lambda) {
  return K + std::max(lambda.maxCoeff(), 1e-30) * M;
}

}  // namespace

ModeSensitivity::ModeSensitivity(const ScaledModel& model,
                                 const VectorXd& theta,
                                 structure::Eigenmodes modes)
    : model_(model),
      modes_(std::move(modes)),
      lambda_(eigenvalues(modes_)),
      K_(model.stiffness(theta)),
      M_(model.mass(theta)),
      MPhi_(M_ * modes_.phi),
      shifted_(shifted(K_, M_, lambda_)) {}

ModeDerivative ModeSensitivity::of(Index mode) const {
  const auto parts = static_cast<Index>(model_.parts.size());
  const VectorXd phi = modes_.phi.col(mode);
  const double lambda = lambda_(mode);
  MatrixXd F = MatrixXd::Zero(phi.size(), parts);
  VectorXd mass = VectorXd::Zero(parts);
  for (Index j = 0; j < parts; ++j) {
    const ScaledPart& part = model_.parts[static_cast<std::size_t>(j)];
    if (part.K.rows() > 0) F.col(j) = part.K * phi;
    if (part.M.rows() == 0) continue;
    const VectorXd inertia = part.M * phi;
    mass(j) = phi.dot(inertia);
    F.col(j) -= lambda * inertia;
  }
  MatrixXd onto = modes_.phi.transpose() * F;
  ModeDerivative result{onto.row(mode), {}};
  const MatrixXd rest = F - MPhi_ * onto;
  for (Index k = 0; k < onto.rows(); ++k) {
    const double apart = lambda - lambda_(k);
    const bool same = std::abs(apart) <= 1e-8 * std::abs(lambda);
    onto.row(k) *= same ? 0.0 : 1.0 / apart;
  }
  onto.row(mode) = -0.5 * mass.transpose();
  result.phi = modes_.phi * onto;
  if (modes_.phi.cols() < phi.size()) {
    result.phi += from_above(-rest, lambda);
  }
  return result;
}

// Conjugate gradients on all columns side by side, each with its own steps;
// in exact arithmetic none leaves the space above the known modes.
MatrixXd ModeSensitivity::from_above(const MatrixXd& F, double lambda) const {
  constexpr double kTolerance = 1e-10;  // in the norm of energy
  constexpr int kMost = 500;
  const auto above = [&](const MatrixXd& X) -> MatrixXd {
    return X - modes_.phi * (MPhi_.transpose() * X);
  };
  MatrixXd X = MatrixXd::Zero(F.rows(), F.cols());
  MatrixXd R = F;
  MatrixXd Z = above(shifted_.solve(R));
  MatrixXd P = Z;
  VectorXd rz = R.cwiseProduct(Z).colwise().sum().transpose();
  const VectorXd first = rz;
  for (int k = 0; k < kMost; ++k) {
    if ((rz.array() <= kTolerance * kTolerance * first.array()).all()) break;
    const MatrixXd AP = K_ * P - lambda * (M_ * P);
    const VectorXd pAp = P.cwiseProduct(AP).colwise().sum().transpose();
    VectorXd alpha = VectorXd::Zero(rz.size());
    for (Index j = 0; j < rz.size(); ++j) {
      if (pAp(j) > 0.0) alpha(j) = rz(j) / pAp(j);
    }
    X += P * alpha.asDiagonal();
    R -= AP * alpha.asDiagonal();
    R -= MPhi_ * (modes_.phi.transpose() * R);
    Z = above(shifted_.solve(R));
    const VectorXd next = R.cwiseProduct(Z).colwise().sum().transpose();
    VectorXd beta = VectorXd::Zero(rz.size());
    for (Index j = 0; j < rz.size(); ++j) {
      if (rz(j) > 0.0) beta(j) = next(j) / rz(j);
    }
    P = Z + P * beta.asDiagonal();
    rz = next;
  }
  return X;
}

}  // namespace tapfit::updating
