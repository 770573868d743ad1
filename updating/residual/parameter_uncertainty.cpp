#include "updating/residual/parameter_uncertainty.hpp"

#include "updating/residual/independent_data.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Of a residual's entries.
double variance(const FittedResidual& test) {
  const double data = effective_data(test.target);
  const double freedom =
      std::min(std::max(1.0, data - static_cast<double>(test.parameters)),
               residual_data(test.target, test.r));
  return std::max(test.r.squaredNorm() / freedom, 1e-300);
}

// Where the errors of form and mesh would drive the parameters.
MatrixXd form_covariance(const std::vector<FittedResidual>& tests,
                         const MatrixXd& bread) {
  std::map<int, VectorXd> bias;  // by deviation
  for (const FittedResidual& test : tests) {
    if (test.target.form_bias.rows() != test.J.rows()) continue;
    const MatrixXd own =
        bread / variance(test) * (test.J.transpose() * test.target.form_bias);
    for (Index k = 0; k < own.cols(); ++k) {
      const int of = test.deviation.empty()
                         ? static_cast<int>(k)
                         : test.deviation[static_cast<std::size_t>(k)];
      auto [it, fresh] = bias.try_emplace(of, own.col(k));
      if (!fresh) it->second += own.col(k);
    }
  }
  MatrixXd sum = MatrixXd::Zero(bread.rows(), bread.cols());
  for (const auto& [of, b] : bias) sum += b * b.transpose();
  return sum;
}

// What each run pulls the parameters by.
void add_run_scores(const FittedResidual& test, std::vector<VectorXd>& scores) {
  std::map<std::size_t, VectorXd> score;
  const double of_entry = variance(test);
  const Index per_frf = 2 * test.target.s.size();
  for (std::size_t f = 0; f < test.target.run.size(); ++f) {
    const Index at = static_cast<Index>(f) * per_frf;
    const VectorXd g = test.J.middleRows(at, per_frf).transpose() *
                       test.r.segment(at, per_frf) / of_entry;
    auto [it, fresh] = score.try_emplace(test.target.run[f], g);
    if (!fresh) it->second += g;
  }
  for (auto& [run, g] : score) scores.push_back(std::move(g));
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
                              const VectorXd& prior_sd,
                              const MatrixXd& known) {
  return parameter_covariance({{target, J, r, J.cols()}}, prior_sd, known);
}

MatrixXd parameter_covariance(const std::vector<FittedResidual>& tests,
                              const VectorXd& prior_sd,
                              const MatrixXd& known) {
  const Index n = prior_sd.size();
  if (n == 0) return MatrixXd(0, 0);
  MatrixXd A = MatrixXd::Zero(n, n);
  for (const FittedResidual& test : tests) {
    A += test.J.transpose() * test.J / variance(test);
  }
  if (known.size() > 0) A += known.transpose() * known;
  for (Index k = 0; k < n; ++k) {
    A(k, k) += std::isfinite(prior_sd(k)) ? std::pow(prior_sd(k), -2) : 0.0;
    A(k, k) = std::max(A(k, k), 1e-12);
  }
  const MatrixXd bread = wide_inverse(A);
  const MatrixXd of_deck = form_covariance(tests, bread);
  std::vector<VectorXd> scores;
  for (const FittedResidual& test : tests) add_run_scores(test, scores);
  const auto groups = static_cast<double>(scores.size());
  // A handful of runs cannot carry a covariance of their own.
  if (groups < 5.0) return within_prior(bread + of_deck, prior_sd);
  MatrixXd meat = MatrixXd::Zero(n, n);
  for (const VectorXd& g : scores) meat += g * g.transpose();
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
