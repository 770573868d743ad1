#include "updating/modal_updating/modal_updater.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/minimiser/bounded_step.hpp"
#include "updating/modal_updating/modal_uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What stays the same throughout.
struct Task {
  const ScaledModel& model;
  const MeasuredModes& measured;
  const Prior& prior;
  VectorXd precision;  // 1 / sd^2, zero where there is no prior
  modal::PairingOptions pairing;
  double independent = 1.0;
  double up_to_hz = 0.0;
};

struct Point {
  VectorXd theta;
  structure::Eigenmodes modes;
  ModalResidual residual;
  double objective = 0.0;
};

Point look(const Task& task, const VectorXd& theta) {
  Point point;
  point.theta = theta;
  point.modes = structure::eigenmodes_up_to(
      task.model.stiffness(theta), task.model.mass(theta), task.up_to_hz);
  point.residual = modal_residual(
      task.measured, point.modes, task.pairing, task.independent);
  point.objective =
      point.residual.misfit +
      (theta - task.prior.mean).cwiseAbs2().cwiseProduct(task.precision).sum();
  return point;
}

// Empty where the model at theta is none: a mechanism, negative stiffness.
std::optional<Point> try_out(const Task& task, const VectorXd& theta) {
  try {
    return look(task, theta);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// The normal equations of the weighted sum of squares at a point.
struct Normal {
  MatrixXd A;
  VectorXd g;

  // How much a step lowers J if r is linear.
  [[nodiscard]] double promise(const VectorXd& step) const {
    return -2.0 * g.dot(step) - step.dot(A * step);
  }

  [[nodiscard]] VectorXd step(const Prior& prior,
                              const VectorXd& theta,
                              double damping) const {
    MatrixXd damped = A;
    // What does not show in the data stays where it is.
    const double least = std::max(1e-13 * A.diagonal().maxCoeff(), 1e-30);
    for (Index k = 0; k < A.rows(); ++k) {
      damped(k, k) += std::max(damping * A(k, k), least);
    }
    return bounded_step(damped, g, prior.lower - theta, prior.upper - theta);
  }
};

Normal normal_equations(const Task& task, const Point& at) {
  const MatrixXd J = modal_jacobian(
      task.model, at.theta, task.measured, at.modes, at.residual);
  const VectorXd& w = at.residual.weight;
  Normal result;
  result.A = J.transpose() * w.asDiagonal() * J;
  result.A.diagonal() += task.precision;
  result.g = J.transpose() * w.cwiseProduct(at.residual.r) +
             task.precision.cwiseProduct(at.theta - task.prior.mean);
  return result;
}

VectorXd bounded(const Prior& prior, const VectorXd& theta) {
  return theta.cwiseMax(prior.lower).cwiseMin(prior.upper);
}

void require_modes(bool good, const std::string& what, const std::string& remedy) {
  if (!good) throw InputError(what, "parameters of the update", remedy);
}

void check(const Prior& prior,
           const VectorXd& start,
           const std::vector<ScaledPart>& parts) {
  const auto n = static_cast<Index>(parts.size());
  require_modes(n > 0, "there is no part to identify", "Name one.");
  require_modes(start.size() == n && prior.mean.size() == n && prior.sd.size() == n &&
              prior.lower.size() == n && prior.upper.size() == n,
          fmt::format("start and prior are not of {} numbers", n),
          "Give one of each for every part.");
  for (Index k = 0; k < n; ++k) {
    const std::string& name = parts[static_cast<std::size_t>(k)].name;
    require_modes(prior.sd(k) > 0.0 && std::isfinite(prior.mean(k)),
            fmt::format("the prior of \"{}\" has no mean or a standard "
                        "deviation of {}",
                        name,
                        prior.sd(k)),
            "The standard deviation is above 0, infinite where nothing is "
            "known.");
    require_modes(prior.lower(k) <= start(k) && start(k) <= prior.upper(k),
            fmt::format("\"{}\" starts at {}, which is not between {} and {}",
                        name,
                        start(k),
                        prior.lower(k),
                        prior.upper(k)),
            "Start within the bounds.");
  }
}

Task make_task(const ScaledModel& model,
               const MeasuredModes& measured,
               const Prior& prior,
               const ModalUpdateOptions& options) {
  const double points = static_cast<double>(measured.dofs.size());
  const double most = std::max(points - 1.0, 1.0);
  const double independent = options.independent.value_or(most);
  require_modes(independent >= 1.0 && independent <= most,
          fmt::format("{} independent readings in a shape of {} points",
                      independent,
                      points),
          fmt::format("Between 1 and {}.", most));
  Task task{model, measured, prior, {}, options.pairing, independent, 0.0};
  task.precision = prior.sd.cwiseAbs2().cwiseInverse();  // 0 for infinity
  // A little above the last that may be paired, so that none is missed.
  task.up_to_hz = 1.01 * options.pairing.most_frequency_ratio *
                  measured.frequency_hz.maxCoeff();
  return task;
}

// Steps from a point until one lowers J; the damping goes along.
struct Advance {
  std::optional<Point> next;  // empty: none does
  double moved = 0.0;         // by the last step tried
  double damping = 0.0;       // of the last step tried
  bool arrived = false;       // the undamped step is next to nothing
};

Advance advance(const Task& task,
                const Point& at,
                const ModalUpdateOptions& options,
                double damping) {
  const Normal normal = normal_equations(task, at);
  const VectorXd full = normal.step(task.prior, at.theta, 0.0);
  Advance result{std::nullopt, 0.0, damping};
  result.arrived = full.cwiseAbs().maxCoeff() <= options.tolerance ||
                   normal.promise(full) <= options.objective_tolerance;
  for (; damping < 1e12; damping *= 5.0) {
    const VectorXd theta = bounded(
        task.prior, at.theta + normal.step(task.prior, at.theta, damping));
    result.damping = damping;
    result.moved = (theta - at.theta).cwiseAbs().maxCoeff();
    std::optional<Point> trial = try_out(task, theta);
    if (trial && trial->objective < at.objective) {
      result.next = std::move(trial);
      break;
    }
    if (result.arrived) break;
  }
  return result;
}

void conclude(const Task& task, const Point& at, ModalUpdate& result) {
  result.theta = at.theta;
  result.objective = at.objective;
  result.after = at.residual;
  const MatrixXd J = modal_jacobian(
      task.model, at.theta, task.measured, at.modes, at.residual);
  const ModalUncertainty uncertainty = modal_uncertainty(
      J, at.residual, task.measured.frequency_hz.size(), task.precision);
  result.covariance = uncertainty.covariance;
  result.standard_error = uncertainty.standard_error;
  result.identifiability = uncertainty.identifiability;
  for (Index k = 0; k < at.theta.size(); ++k) {
    result.at_bound.push_back(at.theta(k) <= task.prior.lower(k) ||
                              at.theta(k) >= task.prior.upper(k));
  }
  const Index left = task.measured.frequency_hz.size() -
                     static_cast<Index>(at.residual.pairs.size());
  if (left == 0) return;
  // What has no partner pulls at nothing.
  result.converged = result.converged && !at.residual.pairs.empty();
  result.message +=
      fmt::format("; {} of {} measured modes have no partner in the model",
                  left,
                  task.measured.frequency_hz.size());
}

}  // namespace

ModalUpdate modal_update(const ScaledModel& model,
                         const MeasuredModes& measured,
                         const Prior& prior,
                         const VectorXd& start,
                         const ModalUpdateOptions& options,
                         const Progress& progress) {
  check(model);
  check(measured, model.K0.rows());
  check(prior, start, model.parts);
  const Task task = make_task(model, measured, prior, options);
  Point at = look(task, start);
  ModalUpdate result;
  result.before = at.residual;
  double damping = 1e-3;
  result.history.push_back(
      {at.objective, 0.0, damping, at.theta, at.residual.frequency_hz});
  result.message =
      fmt::format("not converged in {} steps", options.max_iterations);
  for (int k = 0; k < options.max_iterations; ++k) {
    progress("updating", static_cast<double>(k) / options.max_iterations);
    Advance step = advance(task, at, options, damping);
    if (step.next) {
      at = std::move(*step.next);
      damping = std::max(step.damping * 0.2, 1e-9);
      result.history.push_back({at.objective,
                                step.moved,
                                step.damping,
                                at.theta,
                                at.residual.frequency_hz});
    }
    if (step.arrived) {
      result.converged = true;
      result.message = "converged";
      break;
    }
    if (!step.next) {
      result.message = "no step, however short, lowers the misfit any more";
      break;
    }
  }
  conclude(task, at, result);
  return result;
}

}  // namespace tapfit::updating
