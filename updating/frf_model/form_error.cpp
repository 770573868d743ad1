#include "updating/frf_model/form_error.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A careful deck's modal stiffness is off by 0.6 % in the middle (frequencies
// by 0.3 %), and in two cases of three by 0.2 to 1.8 %.
constexpr double middle_tau = 6e-3;
constexpr double spread = 1.1;  // of ln tau
// Steps of ln tau and ln sigma: a tenth of the width of what they are known to.
constexpr double grid_step = 0.2;
constexpr double least_tau = 1e-5;
constexpr double most_tau = 0.2;

// Of the residual without what the form explains, weighed by the form's prior.
double weighed_square(const FormView& v, double kappa) {
  const auto taken = v.lambda.array() / (kappa + v.lambda.array());
  return std::max(v.whole - (taken * v.along.array()).sum(), 1e-30);
}

// ln p(r | sigma, tau) + ln p(tau), but for constants.
double log_density(const FormView& v, double data, double sigma, double tau) {
  const double kappa = sigma * sigma / (data * tau * tau);
  const double volume = (v.lambda.array() / kappa).log1p().sum();
  const double off = std::log(tau / middle_tau) / spread;
  return -0.5 * (2.0 * data * std::log(sigma) + volume +
                 data * weighed_square(v, kappa) / (sigma * sigma) + off * off);
}

}  // namespace

FormError form_error(const MatrixXd& F) {
  constexpr double told = 1e-10;  // below it a pattern is another one again
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      MatrixXd(F.transpose() * F));
  const VectorXd& all = solver.eigenvalues();
  const Index kept =
      all.size() == 0 ? 0 : (all.array() > told * all.maxCoeff()).count();
  FormError form;
  form.lambda = all.tail(kept);
  form.U = F * (solver.eigenvectors().rightCols(kept) *
                form.lambda.cwiseSqrt().cwiseInverse().asDiagonal());
  return form;
}

FormView view(const FormError& form, const VectorXd& r) {
  return {form.lambda, (form.U.transpose() * r).cwiseAbs2(), r.squaredNorm()};
}

FormEstimate estimate_form(const FormView& v, double data, double noise) {
  const double top = std::sqrt(std::max(v.whole, 1e-30));
  const double bottom = std::max(std::min(noise, 0.99 * top), 1e-3 * top);
  std::vector<double> density;
  FormEstimate best;
  double most = -1e300;
  for (double tau = least_tau; tau < most_tau; tau *= std::exp(grid_step)) {
    for (double sigma = bottom; sigma < 1.01 * top; sigma *= std::exp(grid_step)) {
      density.push_back(log_density(v, data, sigma, tau));
      if (density.back() <= most) continue;
      most = density.back();
      best.tau = tau;
      best.sigma = sigma;
    }
  }
  double sum = 0.0;
  for (const double d : density) sum += std::exp(d - most);
  best.log_likelihood = most + std::log(sum * grid_step * grid_step);
  const double kappa = best.sigma * best.sigma / (data * best.tau * best.tau);
  const auto kept = kappa / (kappa + v.lambda.array());
  const double along = v.along.sum();
  best.left = std::sqrt(
      std::max(0.0, v.whole - along + (kept.square() * v.along.array()).sum()));
  return best;
}

}  // namespace tapfit::updating
