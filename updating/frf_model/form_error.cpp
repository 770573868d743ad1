#include "updating/frf_model/form_error.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>
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

// r' W r + prior at its least over the parameters, with
// W = I - g F S (I + g S F' F S)^-1 S F',
//
//   A d = -b,   A = g J' W J + P,   b = g J' W r + P (theta - mean)
//
// [1 / residual^2]; without the prior's cost at theta.
struct Weighed {
  double square = 0.0;
  VectorXd step;
  double volume = 0.0;  // ln det (I + g S F' F S)
};

// A view with one tau, in coordinates in which S F' F S is tridiagonal: all
// sigmas are told from there in as many operations as there are patterns, and
// where no mesh's error is known all taus are: S is then tau I.
class Scaled {
  // A row is worked on as a whole.
  using Rows =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

 public:
  Scaled(const FormView& view, double tau)
      : view_(&view),
        scale_((view.mesh_sd.array().square() + tau * tau).sqrt()) {
    if (!view.has_patterns()) return;
    const Eigen::Tridiagonalization<MatrixXd> reduced(
        MatrixXd(scale_.asDiagonal() * view.patterns * scale_.asDiagonal()));
    diagonal_ = reduced.diagonal();
    beside_ = reduced.subDiagonal();
    const auto Q = reduced.matrixQ();
    along_ = Q.adjoint() * VectorXd(scale_.cwiseProduct(view.along));
    if (view.moved.size() > 0) {
      moved_ = Q.adjoint() * MatrixXd(scale_.asDiagonal() * view.moved);
    }
  }

  /// @param h g, or with S in units of some tau g times that tau's square
  [[nodiscard]] Weighed weigh(double g, double h) const {
    const FormView& v = *view_;
    Weighed result;
    const Index k = along_.size();
    Rows solved(k, 1 + moved_.cols());
    solved.col(0) = along_;
    if (moved_.size() > 0) solved.rightCols(moved_.cols()) = moved_;
    result.volume = solve(h, solved);
    const double own = v.whole - h * along_.dot(solved.col(0));
    result.square = g * std::max(own, 1e-30);
    if (v.slope.size() == 0) return result;
    MatrixXd A = g * v.gram;
    VectorXd b = g * v.slope + v.pull;
    if (k > 0) {
      A -= g * h * moved_.transpose() * solved.rightCols(moved_.cols());
      b -= g * h * moved_.transpose() * solved.col(0);
    }
    A += v.information;
    A.diagonal().array() += 1.0 / (first_order * first_order);
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

  // The likeliest e with what is left along the patterns.
  [[nodiscard]] VectorXd likeliest(const VectorXd& along, double g) const {
    MatrixXd B =
        g * (scale_.asDiagonal() * view_->patterns * scale_.asDiagonal());
    B.diagonal().array() += 1.0;
    return g * scale_.cwiseProduct(
                   B.ldlt().solve(VectorXd(scale_.cwiseProduct(along))));
  }

 private:
  // (I + g T)^-1 X in place; ln det of what is inverted.
  double solve(double g, Rows& X) const {
    const Index k = X.rows();
    VectorXd pivot(k);
    double volume = 0.0;
    for (Index i = 0; i < k; ++i) {
      pivot(i) = 1.0 + g * diagonal_(i);
      if (i > 0) {
        const double over = g * beside_(i - 1) / pivot(i - 1);
        pivot(i) -= over * g * beside_(i - 1);
        X.row(i) -= over * X.row(i - 1);
      }
      pivot(i) = std::max(pivot(i), 1.0);
      volume += std::log(pivot(i));
    }
    for (Index i = k - 1; i >= 0; --i) {
      if (i + 1 < k) X.row(i) -= g * beside_(i) * X.row(i + 1);
      X.row(i) *= 1.0 / pivot(i);
    }
    return volume;
  }

  const FormView* view_;
  VectorXd scale_;  // S
  VectorXd diagonal_;
  VectorXd beside_;
  VectorXd along_;
  MatrixXd moved_;
};

struct Density {
  double log = 0.0;  // ln p(r | sigma, tau) + ln p(tau), but for constants
  double sigma = 0.0;
};

// Of ln sigma.
constexpr double close = 0.02;

// A view with one of the taus.
struct AtTau {
  double tau = 0.0;
  const Scaled& scaled;
  double square = 1.0;  // tau^2, where S is in units of it
};

double log_density(const FormView& v,
                   const AtTau& at,
                   double data,
                   double sigma) {
  const double off = std::log(at.tau / (v.allowance * middle_tau)) / spread;
  const double g = data / (sigma * sigma);
  const Weighed weighed = at.scaled.weigh(g, at.square * g);
  return -0.5 * (2.0 * data * std::log(sigma) + weighed.volume +
                 weighed.square + off * off);
}

// The largest of a function with one top, by golden section.
template <typename Function>
Density top_of(const Function& at, double low, double high) {
  constexpr double golden = 0.618033988749895;
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

struct Range {
  double bottom = 0.0;
  double top = 0.0;
};

// The sigma that is likeliest with tau; near that of a tau beside it, where
// there is one. Its width, 1 / sqrt(2 N), is the same for all that are
// compared.
Density best_sigma(const FormView& v,
                   double data,
                   const AtTau& with,
                   const Range& sigma,
                   double near) {
  constexpr double reach = 0.25;
  const auto at = [&](double x) {
    return log_density(v, with, data, std::exp(x));
  };
  const double bottom = std::log(sigma.bottom);
  const double top = std::log(sigma.top);
  if (near > 0.0) {
    const double low = std::max(bottom, std::log(near) - reach);
    const double high = std::min(top, std::log(near) + reach);
    const Density found = top_of(at, low, high);
    const double x = std::log(found.sigma);
    const bool above = x > low + close || low == bottom;
    const bool below = x < high - close || high == top;
    if (above && below) return found;
  }
  return top_of(at, bottom, top);
}

// One tau of the grid.
struct Tried {
  double tau = 0.0;
  double log_density = 0.0;
  double sigma = 0.0;  // the likeliest with it
};

// Of the grid's step around a tau the share that is no less than a least tau.
double share_above(double least, double tau) {
  return std::clamp(0.5 + std::log(tau / least) / grid_step, 0.0, 1.0);
}

// Every third tau, and those between where they count: in the integral over all
// taus, or over those that are usual and more.
std::vector<Tried> tried_grid(const FormView& v,
                              double data,
                              double noise,
                              double usual) {
  constexpr std::size_t coarse = 3;
  constexpr double nothing = 25.0;  // of log density below the most
  const double top = std::sqrt(std::max(v.whole, 1e-30));
  const Range sigma{std::max(std::min(noise, 0.99 * top), 1e-3 * top), top};
  std::optional<Scaled> unit;
  if (v.mesh_sd.isZero(0.0)) unit.emplace(v, 1.0);
  const auto at = [&](double tau, double near) {
    std::optional<Scaled> own;
    if (!unit) own.emplace(v, tau);
    const AtTau with{tau, unit ? *unit : *own, unit ? tau * tau : 1.0};
    const Density found = best_sigma(v, data, with, sigma, near);
    return Tried{tau, found.log, found.sigma};
  };
  std::vector<double> taus;
  for (double tau = least_tau; tau < most_tau; tau *= std::exp(grid_step)) {
    taus.push_back(tau);
  }
  std::vector<Tried> rough;
  for (std::size_t k = 0; k < taus.size(); k += coarse) {
    rough.push_back(at(taus[k], rough.empty() ? 0.0 : rough.back().sigma));
  }
  double most = -1e300;
  double most_usual = -1e300;
  for (const Tried& tried : rough) {
    most = std::max(most, tried.log_density);
    if (tried.tau < usual) continue;
    most_usual = std::max(most_usual, tried.log_density);
  }
  std::vector<Tried> grid;
  for (std::size_t k = 0; k < rough.size(); ++k) {
    grid.push_back(rough[k]);
    const Tried& next = rough[std::min(k + 1, rough.size() - 1)];
    const double here = std::max(rough[k].log_density, next.log_density);
    const bool holds_usual = rough[k].tau < usual && usual <= next.tau;
    const bool counts = here > most - nothing ||
                        (next.tau >= usual && here > most_usual - nothing) ||
                        holds_usual;
    if (!counts) continue;
    for (std::size_t j = coarse * k + 1;
         j < std::min(coarse * (k + 1), taus.size());
         ++j) {
      grid.push_back(at(taus[j], rough[k].sigma));
    }
  }
  return grid;
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

FormView view(const FormError& form,
              const VectorXd& r,
              const Readjustment& fit) {
  FormView seen;
  seen.patterns.setZero(form.F.cols(), form.F.cols());
  seen.patterns.selfadjointView<Eigen::Lower>().rankUpdate(form.F.transpose());
  seen.patterns = MatrixXd(seen.patterns.selfadjointView<Eigen::Lower>());
  seen.mesh_sd = form.mesh_sd;
  seen.along = form.F.transpose() * r;
  seen.whole = r.squaredNorm();
  if (fit.J.size() == 0) return seen;
  seen.moved = form.F.transpose() * fit.J;
  seen.gram = fit.J.transpose() * fit.J;
  seen.slope = fit.J.transpose() * r;
  seen.information = fit.information;
  seen.pull = fit.pull;
  return seen;
}

FormEstimate estimate_form(const FormView& v, double data, double noise) {
  const double usual = v.allowance * middle_tau;
  const std::vector<Tried> grid = tried_grid(v, data, noise, usual);
  const Tried& top = *std::ranges::max_element(grid, {}, &Tried::log_density);
  FormEstimate best;
  best.tau = top.tau;
  best.sigma = top.sigma;
  best.mean_tau = mean_tau_of(grid, top.log_density);
  best.log_likelihood = log_integral(grid, 0.0);
  best.log_likelihood_if_usual = log_integral(grid, usual);
  const double g = data / (best.sigma * best.sigma);
  const Scaled likeliest(v, best.tau);
  best.step = likeliest.weigh(g, g).step;
  VectorXd along = v.along;
  double whole = v.whole;
  if (best.step.size() > 0) {
    along += v.moved * best.step;
    whole += best.step.dot(2.0 * v.slope + v.gram * best.step);
  }
  if (v.has_patterns()) {
    const VectorXd e = likeliest.likeliest(along, g);
    whole += e.dot(v.patterns * e - 2.0 * along);
  }
  best.left = std::sqrt(std::max(0.0, whole));
  return best;
}

}  // namespace tapfit::updating
