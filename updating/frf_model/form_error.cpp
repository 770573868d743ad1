#include "updating/frf_model/form_error.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double spread = 1.1;     // of ln tau, see middle_tau
constexpr double grid_step = 0.3;  // of ln tau
constexpr double least_tau = 1e-5;
constexpr double most_tau = 0.2;
// How far the first order reaches, in the parameters' logarithms: a factor.
constexpr double first_order = 0.5;

// r' W r + prior at its least over the parameters, with W = I - U D U',
// D = lambda / (kappa + lambda):
//
//   A d = -b,   A = g J' W J + P,   b = g J' W r + P (theta - mean)
//
// g = N / sigma^2 [1 / residual^2]; without the prior's cost at theta.
struct Weighed {
  double square = 0.0;
  VectorXd step;
};

Weighed weigh(const FormView& v, double kappa, double g) {
  const VectorXd taken = v.lambda.array() / (kappa + v.lambda.array());
  const double own = v.whole - taken.dot(v.along.cwiseAbs2());
  Weighed result{g * std::max(own, 1e-30), {}};
  if (v.slope.size() == 0) return result;
  const MatrixXd weighed = taken.asDiagonal() * v.moved;
  MatrixXd A = g * (v.gram - v.moved.transpose() * weighed);
  A.diagonal() += v.precision;
  A.diagonal().array() += 1.0 / (first_order * first_order);
  const VectorXd b = g * (v.slope - weighed.transpose() * v.along) + v.pull;
  result.step = -A.ldlt().solve(b);
  const double gain = b.dot(result.step);
  // What is left of a sum of squares is one: else the slopes are rounding.
  if (result.square + gain > 0.0) {
    result.square += gain;
  } else {
    result.step.setZero();
  }
  return result;
}

struct Density {
  double log = 0.0;  // ln p(r | sigma, tau) + ln p(tau), but for constants
  double sigma = 0.0;
};

double log_density(const FormView& v, double data, double sigma, double tau) {
  const double kappa = sigma * sigma / (data * tau * tau);
  const double volume = (v.lambda.array() / kappa).log1p().sum();
  const double off = std::log(tau / (v.allowance * middle_tau)) / spread;
  const double g = data / (sigma * sigma);
  return -0.5 * (2.0 * data * std::log(sigma) + volume +
                 weigh(v, kappa, g).square + off * off);
}

// The sigma that is likeliest with tau, by golden section of its logarithm. Its
// width, 1 / sqrt(2 N), is the same for all that are compared.
Density best_sigma(
    const FormView& v, double data, double tau, double bottom, double top) {
  constexpr double golden = 0.618033988749895;
  constexpr double close = 0.02;
  double low = std::log(bottom);
  double high = std::log(top);
  const auto at = [&](double x) {
    return log_density(v, data, std::exp(x), tau);
  };
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double fa = at(a);
  double fb = at(b);
  while (high - low > close) {
    if (fa > fb) {
      high = b;
      b = a;
      fb = fa;
      a = high - golden * (high - low);
      fa = at(a);
    } else {
      low = a;
      a = b;
      fa = fb;
      b = low + golden * (high - low);
      fb = at(b);
    }
  }
  return fa > fb ? Density{fa, std::exp(a)} : Density{fb, std::exp(b)};
}

// One tau of the grid.
struct Tried {
  double tau = 0.0;
  double log_density = 0.0;
};

// Of the grid's step around a tau the share that is no less than a least tau.
double share_above(double least, double tau) {
  return std::clamp(0.5 + std::log(tau / least) / grid_step, 0.0, 1.0);
}

// ln of the integral of the density over ln tau, from a least tau on.
double log_integral(const std::vector<Tried>& grid, double least) {
  double most = -1e300;
  for (const Tried& at : grid) {
    if (share_above(least, at.tau) == 0.0) continue;
    most = std::max(most, at.log_density);
  }
  double sum = 0.0;
  for (const Tried& at : grid) {
    sum += share_above(least, at.tau) * std::exp(at.log_density - most);
  }
  return most + std::log(sum * grid_step);
}

// Root of the mean of tau^2, however small it is.
double mean_tau_of(const std::vector<Tried>& grid, double most) {
  double sum = 0.0;
  double squares = 0.0;
  for (const Tried& at : grid) {
    const double p = std::exp(at.log_density - most);
    sum += p;
    squares += p * at.tau * at.tau;
  }
  return std::sqrt(squares / sum);
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

FormView view(const FormError& form,
              const VectorXd& r,
              const Readjustment& fit) {
  if (fit.J.size() == 0) {
    return {form.lambda, form.U.transpose() * r, r.squaredNorm(), {}, {}, {}};
  }
  return {form.lambda,
          form.U.transpose() * r,
          r.squaredNorm(),
          form.U.transpose() * fit.J,
          fit.J.transpose() * fit.J,
          fit.J.transpose() * r,
          fit.precision,
          fit.pull};
}

FormEstimate estimate_form(const FormView& v, double data, double noise) {
  const double top = std::sqrt(std::max(v.whole, 1e-30));
  const double bottom = std::max(std::min(noise, 0.99 * top), 1e-3 * top);
  std::vector<Tried> grid;
  FormEstimate best;
  double most = -1e300;
  for (double tau = least_tau; tau < most_tau; tau *= std::exp(grid_step)) {
    const Density at = best_sigma(v, data, tau, bottom, top);
    grid.push_back({tau, at.log});
    if (at.log <= most) continue;
    most = at.log;
    best.tau = tau;
    best.sigma = at.sigma;
  }
  best.mean_tau = mean_tau_of(grid, most);
  best.log_likelihood = log_integral(grid, 0.0);
  best.log_likelihood_if_usual = log_integral(grid, v.allowance * middle_tau);
  const double g = data / (best.sigma * best.sigma);
  const double kappa = 1.0 / (g * best.tau * best.tau);
  best.step = weigh(v, kappa, g).step;
  VectorXd along = v.along;
  double whole = v.whole;
  if (best.step.size() > 0) {
    along += v.moved * best.step;
    whole += best.step.dot(2.0 * v.slope + v.gram * best.step);
  }
  const VectorXd kept = kappa / (kappa + v.lambda.array());
  best.left = std::sqrt(std::max(
      0.0,
      whole - along.squaredNorm() + kept.cwiseProduct(along).squaredNorm()));
  return best;
}

}  // namespace tapfit::updating
