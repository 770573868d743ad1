#include "updating/modal_updating/shape_fit.hpp"

#include <cmath>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// Everything at a given e^2.
struct Trial {
  double e2 = 0.0;
  ShapeFit fit;
  double slope = 0.0;  // d misfit / d e^2, a being at its best
};

Trial fit_at(const MatrixXd& u,
             const MatrixXd& phi,
             const MatrixXd& sd,
             double e2) {
  const RowVectorXd size2 = u.cwiseAbs2().colwise().mean();
  const MatrixXd v = VectorXd::Ones(u.rows()) * (e2 * size2);
  const MatrixXd variance = sd.cwiseAbs2() + v;
  const MatrixXd weighted = phi.cwiseQuotient(variance);
  const RowVectorXd square = weighted.cwiseProduct(phi).colwise().sum();
  Trial trial;
  trial.e2 = e2;
  ShapeFit& fit = trial.fit;
  fit.factor = weighted.cwiseProduct(u).colwise().sum().transpose();
  for (Index k = 0; k < square.size(); ++k) {
    fit.factor(k) = square(k) > 0.0 ? fit.factor(k) / square(k) : 0.0;
  }
  fit.excess = (e2 * size2).cwiseSqrt().transpose();
  fit.r =
      (u - phi * fit.factor.asDiagonal()).cwiseQuotient(variance.cwiseSqrt());
  fit.misfit = fit.r.squaredNorm() +
               v.cwiseQuotient(sd.cwiseAbs2()).array().log1p().sum();
  const MatrixXd each =
      (1.0 - fit.r.array().square()).matrix().cwiseQuotient(variance);
  trial.slope = (each * size2.asDiagonal()).sum();
  return trial;
}

}  // namespace

// Where sd differ much the misfit may have several minima in e: the lowest of a
// coarse run over all sizes is refined by halving between its neighbours.
ShapeFit fit_shapes(const MatrixXd& u,
                    const MatrixXd& phi,
                    const MatrixXd& sd) {
  constexpr double kRatio = 1.5;
  Trial best = fit_at(u, phi, sd, 0.0);
  const RowVectorXd size2 = u.cwiseAbs2().colwise().mean();
  const double least =
      1e-4 * (sd.cwiseAbs2() * size2.cwiseInverse().asDiagonal()).minCoeff();
  // Beyond the upper end all of u is excess.
  const auto most = static_cast<double>(u.rows());
  double e2 = least;
  while (e2 < kRatio * most) {
    Trial trial = fit_at(u, phi, sd, e2);
    if (trial.fit.misfit < best.fit.misfit) best = std::move(trial);
    e2 *= kRatio;
  }
  if (best.e2 == 0.0) return best.fit;
  double low = best.e2 / kRatio;
  double high = best.e2 * kRatio;
  for (int k = 0; k < 60; ++k) {
    Trial trial = fit_at(u, phi, sd, 0.5 * (low + high));
    (trial.slope > 0.0 ? high : low) = trial.e2;
    if (trial.fit.misfit <= best.fit.misfit) best = std::move(trial);
  }
  return best.fit;
}

}  // namespace tapfit::updating
