#include "updating/residual/parameter_uncertainty.hpp"

#include "updating/residual/independent_data.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Where the errors of form and mesh would drive the parameters.
MatrixXd form_covariance(const Target& target,
                         const MatrixXd& J,
                         const MatrixXd& gain) {
  if (target.form_bias.rows() != J.rows()) {
    return MatrixXd::Zero(J.cols(), J.cols());
  }
  const MatrixXd bias = gain * (J.transpose() * target.form_bias);
  return bias * bias.transpose();
}

// A^-1, wide where A tells next to nothing: two effects that do the same have
// large variances and a correlation near -1, not whatever rounding makes them.
MatrixXd wide_inverse(const MatrixXd& A) {
  constexpr double told = 1e-12;  // of a parameter's own information
  const VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      MatrixXd(scale.asDiagonal() * A * scale.asDiagonal()));
  const MatrixXd U = scale.asDiagonal() * solver.eigenvectors();
  return U * solver.eigenvalues().cwiseMax(told).cwiseInverse().asDiagonal() *
         U.transpose();
}

// Whatever is added for mesh and model form: nothing is known less than it was
// before anything was measured.
MatrixXd within_prior(const MatrixXd& covariance, const VectorXd& prior_sd) {
  VectorXd scale = VectorXd::Ones(covariance.rows());
  for (Index k = 0; k < scale.size(); ++k) {
    const double sd = std::sqrt(covariance(k, k));
    if (sd > prior_sd(k)) scale(k) = prior_sd(k) / sd;
  }
  return scale.asDiagonal() * covariance * scale.asDiagonal();
}

}  // namespace

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
  const MatrixXd bread = wide_inverse(A);

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
  const MatrixXd gain = bread / variance;
  const MatrixXd of_deck = form_covariance(target, J, gain);
  // A handful of runs cannot carry a covariance of their own.
  if (groups < 5.0) return within_prior(bread + of_deck, prior_sd);
  MatrixXd meat = MatrixXd::Zero(n, n);
  for (const auto& [run, g] : score) meat += g * g.transpose();
  const MatrixXd robust = groups / (groups - 1.0) * bread * meat * bread;
  VectorXd widen(n);
  for (Index k = 0; k < n; ++k) {
    widen(k) =
        std::sqrt(std::max(1.0, robust(k, k) / std::max(bread(k, k), 1e-300)));
  }
  return within_prior(widen.asDiagonal() * bread * widen.asDiagonal() + of_deck,
                      prior_sd);
}

}  // namespace tapfit::updating
