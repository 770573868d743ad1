#include "updating/parameter_uncertainty.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <map>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd parameter_covariance(const Target& target,
                              const MatrixXd& J,
                              const VectorXd& r,
                              const VectorXd& prior_sd) {
  const Index n = J.cols();
  if (n == 0) return MatrixXd(0, 0);
  const double data = effective_data(target);
  const double freedom = std::min(std::max(1.0, data - static_cast<double>(n)),
                                  residual_data(target, r));
  const double variance = std::max(r.squaredNorm() / freedom, 1e-300);
  MatrixXd A = J.transpose() * J / variance;
  for (Index k = 0; k < n; ++k) {
    A(k, k) += std::isfinite(prior_sd(k)) ? std::pow(prior_sd(k), -2) : 0.0;
    A(k, k) = std::max(A(k, k), 1e-12);
  }
  const MatrixXd bread = A.ldlt().solve(MatrixXd::Identity(n, n));

  std::map<std::size_t, VectorXd> score;
  const Index per_frf = 2 * target.s.size();
  for (std::size_t f = 0; f < target.run.size(); ++f) {
    const Index at = static_cast<Index>(f) * per_frf;
    const VectorXd g = J.middleRows(at, per_frf).transpose() *
                       r.segment(at, per_frf) / variance;
    auto [it, fresh] = score.try_emplace(target.run[f], g);
    if (!fresh) it->second += g;
  }
  const auto groups = static_cast<double>(score.size());
  MatrixXd of_mesh = MatrixXd::Zero(n, n);
  if (target.mesh_bias.size() == r.size()) {
    // Where the mesh's error would drive the parameters.
    const VectorXd bias = bread * (J.transpose() * target.mesh_bias) / variance;
    of_mesh = bias * bias.transpose();
  }
  // A handful of runs cannot carry a covariance of their own.
  if (groups < 5.0) return bread + of_mesh;
  MatrixXd meat = MatrixXd::Zero(n, n);
  for (const auto& [run, g] : score) meat += g * g.transpose();
  const MatrixXd robust = groups / (groups - 1.0) * bread * meat * bread;
  VectorXd widen(n);
  for (Index k = 0; k < n; ++k) {
    widen(k) =
        std::sqrt(std::max(1.0, robust(k, k) / std::max(bread(k, k), 1e-300)));
  }
  return widen.asDiagonal() * bread * widen.asDiagonal() + of_mesh;
}

}  // namespace tapfit::updating
