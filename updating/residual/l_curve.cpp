#include "updating/residual/l_curve.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TikhonovSystem::TikhonovSystem(const MatrixXd& S, const VectorXd& d)
    : svd_(S, Eigen::ComputeThinU | Eigen::ComputeThinV),
      beta_(svd_.matrixU().transpose() * d),
      outside_(std::max(d.squaredNorm() - beta_.squaredNorm(), 0.0)) {}

VectorXd TikhonovSystem::solve(double lambda) const {
  const VectorXd& s = svd_.singularValues();
  const double rounding = 1e-14 * s(0);
  VectorXd x(s.size());
  for (Index k = 0; k < s.size(); ++k) {
    x(k) = s(k) > rounding ? s(k) * beta_(k) / (s(k) * s(k) + lambda * lambda)
                           : 0.0;
  }
  return svd_.matrixV() * x;
}

LCurve TikhonovSystem::l_curve(int points) const {
  const ArrayXd s =
      svd_.singularValues().array().max(1e-14 * svd_.singularValues()(0));
  const double top = std::log(s(0));
  const double bottom = std::max(std::log(s(s.size() - 1)) - 5.0, top - 28.0);
  LCurve curve;
  curve.lambda = VectorXd::LinSpaced(points, bottom, top).array().exp();
  curve.residual_norm.resize(points);
  curve.solution_norm.resize(points);
  curve.curvature.resize(points);
  for (Index k = 0; k < points; ++k) {
    const double l = curve.lambda(k);
    const ArrayXd kept = s.square() / (s.square() + l * l);
    const ArrayXd x2 = (kept * beta_.array() / s).square();
    const double rho = ((1.0 - kept) * beta_.array()).square().sum() + outside_;
    const double eta = x2.sum();
    const double slope = -4.0 / l * ((1.0 - kept) * x2).sum();
    curve.residual_norm(k) = std::sqrt(rho);
    curve.solution_norm(k) = std::sqrt(eta);
    const double turn =
        l * l * slope * rho + 2.0 * l * eta * rho + l * l * l * l * eta * slope;
    const double arc = std::pow(std::pow(l, 4) * eta * eta + rho * rho, 1.5);
    const double curvature = -2.0 * eta * rho / slope * turn / arc;
    curve.curvature(k) = std::isfinite(curvature) ? curvature : 0.0;
  }
  curve.curvature.maxCoeff(&curve.corner);
  return curve;
}

}  // namespace tapfit::updating
