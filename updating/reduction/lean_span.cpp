#include "updating/reduction/lean_span.hpp"

#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/base_matrices.hpp"
#include "updating/reduction/subspace.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Modes are kept to this many times the top of the band, and what properties
// make of those up to a little above it is looked at.
constexpr double kept_reach = 2.5;
constexpr double looked_at_reach = 1.3;

// Of the amplitude (root of the energy) of a mode, or of all that a point
// answers: what is left is its square, in frequency and in flexibility.
constexpr double negligible = 1e-6;

// The coordinates beyond the modes that are kept.
struct Beyond {
  Index first = 0;
  VectorXd lambda;
};

// What driven points answer through the modes beyond, at rest and at the top
// of the band, per root of all that they answer.
MatrixXd answers(const ReducedBase& base,
                 const Beyond& beyond,
                 const MatrixXd& driven,
                 double top) {
  const VectorXd all = base.K.diagonal().cwiseMax(1e-3 * top);
  constexpr Index shifts = 3;
  MatrixXd result(beyond.lambda.size(), shifts * driven.cols());
  for (Index p = 0; p < driven.cols(); ++p) {
    const double flexibility =
        driven.col(p).cwiseAbs2().cwiseQuotient(all).sum();
    const VectorXd felt = driven.col(p).tail(beyond.lambda.size()) /
                          std::sqrt(std::max(flexibility, 1e-300));
    for (Index k = 0; k < shifts; ++k) {
      const double sigma = top * static_cast<double>(k) / (shifts - 1);
      result.col(shifts * p + k) =
          felt.array() / (beyond.lambda.array() - sigma);
    }
  }
  return result;
}

// What the modes of other properties need beyond those kept, per root of their
// own stiffness.
MatrixXd changed_modes(const ReducedBase& base,
                       const Beyond& beyond,
                       const std::vector<double>& factor,
                       double top) {
  MatrixXd K = base.K;
  MatrixXd M = MatrixXd::Identity(base.size(), base.size());
  for (std::size_t t = 0; t < base.part_power.size(); ++t) {
    const double c = part_coefficient(base.part_power[t], factor);
    if (c == 0.0) continue;
    K += c * base.K_part[t];
    M += c * base.M_part[t];
  }
  const Index m = beyond.first;
  const Index h = beyond.lambda.size();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> kept(
      MatrixXd(K.topLeftCorner(m, m)), MatrixXd(M.topLeftCorner(m, m)));
  const VectorXd lambda = kept.eigenvalues().cwiseMax(0.0);
  const Index count =
      (lambda.array() < looked_at_reach * looked_at_reach * top).count();
  const MatrixXd phi = kept.eigenvectors().leftCols(count);
  MatrixXd load = K.bottomLeftCorner(h, m) * phi;
  load -= M.bottomLeftCorner(h, m) * phi * lambda.head(count).asDiagonal();
  for (Index k = 0; k < count; ++k) {
    load.col(k) /= std::sqrt(std::max(lambda(k), 1e-2 * top));
  }
  return -K.bottomRightCorner(h, h).ldlt().solve(load);
}

}  // namespace

MatrixXd lean_span(const ReducedBase& base,
                   const MatrixXd& driven,
                   const LeanOptions& options) {
  const double top = std::pow(2.0 * std::numbers::pi * options.high_hz, 2);
  const VectorXd lambda = base.K.diagonal();
  Beyond beyond;
  beyond.first = std::min<Index>(
      std::max<Index>((lambda.array() < kept_reach * kept_reach * top).count(),
                      1),
      base.size());
  beyond.lambda = lambda.tail(base.size() - beyond.first);
  const Index h = beyond.lambda.size();
  if (h == 0) return MatrixXd::Identity(base.size(), base.size());
  std::vector<MatrixXd> all = {answers(base, beyond, driven, top)};
  const std::vector<double> nominal(options.spread.size(), 1.0);
  for (std::size_t j = 0; j < options.spread.size(); ++j) {
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> factor = nominal;
      factor[j] = std::exp(sign * options.spread[j]);
      all.push_back(changed_modes(base, beyond, factor, top));
    }
  }
  // In the coordinates in which stiffness is the unit.
  const VectorXd root = beyond.lambda.cwiseSqrt();
  const MatrixXd S = root.asDiagonal() * join(all);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(S * S.transpose());
  const Index kept =
      (gram.eigenvalues().array() > negligible * negligible).count();
  MatrixXd span = MatrixXd::Zero(base.size(), beyond.first + kept);
  span.topLeftCorner(beyond.first, beyond.first).setIdentity();
  // Frequencies alone are measured at no point.
  if (kept == 0) return span;
  const MatrixXd directions =
      root.cwiseInverse().asDiagonal() * gram.eigenvectors().rightCols(kept);
  span.bottomRightCorner(h, kept) =
      Eigen::HouseholderQR<MatrixXd>(directions).householderQ() *
      MatrixXd::Identity(h, kept);
  return span;
}

}  // namespace tapfit::updating
