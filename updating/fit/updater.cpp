#include "updating/fit/updater.hpp"

#include "updating/fit/fit_watch.hpp"
#include "updating/fit/parameter_uncertainty.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Point {
  VectorXd theta;
  Eigen::MatrixXcd H;  // lines x FRFs
  VectorXd r;
  MatrixXd J;  // dr / d theta
  double prior_cost = 0.0;
  double objective = 0.0;
};

std::optional<Point> look(const FrfModel& model,
                          const Target& target,
                          const ModelState& like,
                          const Prior& prior,
                          const VectorXd& theta) {
  ModelResponse response = model.respond(unpack(like, theta), target.s, true);
  if (!response.H.allFinite()) return std::nullopt;
  Point point;
  point.theta = theta;
  point.r = stack(target, response.H - target.H);
  point.J.resize(point.r.size(), theta.size());
  for (std::size_t k = 0; k < response.dH.size(); ++k) {
    point.J.col(static_cast<Index>(k)) = stack(target, response.dH[k]);
  }
  point.H = std::move(response.H);
  const double misfit = std::max(point.r.squaredNorm(), 1e-30);
  point.prior_cost =
      ((theta - prior.mean).cwiseAbs2().array() * precision(prior).array())
          .sum();
  point.objective =
      effective_data(target) * std::log(misfit) + point.prior_cost;
  return point;
}

// One damped step from a point; components at a bound that would leave it
// stay there.
VectorXd step(const Point& at,
              const Prior& prior,
              double data,
              double damping) {
  const double weight = data / std::max(at.r.squaredNorm(), 1e-30);
  const VectorXd p = precision(prior);
  MatrixXd A = weight * at.J.transpose() * at.J;
  VectorXd g =
      weight * at.J.transpose() * at.r + p.cwiseProduct(at.theta - prior.mean);
  for (Index k = 0; k < A.rows(); ++k) {
    const bool low = at.theta(k) <= prior.lower(k) && g(k) > 0.0;
    const bool high = at.theta(k) >= prior.upper(k) && g(k) < 0.0;
    if (low || high) {
      A.row(k).setZero();
      A.col(k).setZero();
      g(k) = 0.0;
    }
    A(k, k) += p(k);
    A(k, k) += damping * std::max(A(k, k), 1e-9) + 1e-12;
  }
  const VectorXd d = -A.ldlt().solve(g);
  // A logarithm that moves by more than 1 has left the linear range.
  const double longest = d.cwiseAbs().maxCoeff();
  return longest > 1.0 ? VectorXd(d / longest) : d;
}

}  // namespace

VectorXd precision(const Prior& prior) {
  VectorXd result(prior.sd.size());
  for (Index k = 0; k < result.size(); ++k) {
    result(k) =
        std::isfinite(prior.sd(k)) ? 1.0 / (prior.sd(k) * prior.sd(k)) : 0.0;
  }
  return result;
}

UpdateResult update(const FrfModel& model,
                    const Target& target,
                    const ModelState& start,
                    const Prior& prior,
                    const UpdateOptions& options,
                    const Progress& progress) {
  UpdateResult result;
  const double data = effective_data(target);
  const VectorXd first =
      pack(start).cwiseMax(prior.lower).cwiseMin(prior.upper);
  std::optional<Point> at = look(model, target, start, prior, first);
  result.state = unpack(start, first);
  if (!at) {
    result.message = "the model's FRFs are not finite at the start";
    return result;
  }
  double damping = 1e-3;
  result.history.push_back({at->r.norm(), 0.0, damping, at->theta});
  result.message = first.size() == 0 ? "nothing to identify"
                                     : fmt::format("not converged in {} steps",
                                                   options.max_iterations);
  for (int k = 0; k < options.max_iterations && first.size() > 0; ++k) {
    progress("updating", static_cast<double>(k) / options.max_iterations);
    bool improved = false;
    double moved = 0.0;
    double gained = 0.0;
    double used = damping;
    while (!improved && damping < 1e8) {
      const VectorXd next = (at->theta + step(*at, prior, data, damping))
                                .cwiseMax(prior.lower)
                                .cwiseMin(prior.upper);
      used = damping;
      moved = (next - at->theta).cwiseAbs().maxCoeff();
      std::optional<Point> trial = look(model, target, start, prior, next);
      improved = trial && trial->objective < at->objective;
      if (improved) {
        gained = at->objective - trial->objective;
        at = std::move(trial);
        damping = std::max(damping * 0.2, 1e-9);
      } else {
        if (moved <= options.tolerance) break;
        damping *= 6.0;
      }
    }
    if (improved) {
      result.history.push_back({at->r.norm(), moved, used, at->theta});
      if (const FitWatch* watch = watch_of(progress)) {
        watch->step({result.history.back(),
                     model,
                     target,
                     prior,
                     unpack(start, at->theta),
                     at->H,
                     parameter_covariance(target, at->J, at->r, prior.sd)});
      }
    }
    // A short step under heavy damping gains little wherever it is.
    result.converged =
        moved <= options.tolerance ||
        (improved && damping < 1e-2 && gained <= options.objective_tolerance);
    if (!result.converged && !improved) {
      result.message = "no step, however short, lowers the error any more";
    }
    if (result.converged || !improved) break;
    if (is_enough(progress)) {
      result.message = "stopped by hand";
      break;
    }
  }
  result.state = unpack(start, at->theta);
  result.error = at->r.norm();
  result.objective = at->objective;
  result.prior_cost = at->prior_cost;
  result.covariance = parameter_covariance(target, at->J, at->r, prior.sd);
  result.jacobian = at->J;
  result.residual = at->r;
  result.prior = prior;
  result.lambda = at->r.norm() / std::sqrt(data);
  if (result.converged) result.message = "converged";
  return result;
}

}  // namespace tapfit::updating
