#include "updating/fit/plain_fit.hpp"

#include "updating/residual/parameter_uncertainty.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The lines in use alone, weighted as the plain residual: receptances.
Target used_lines(const Target& target, const std::vector<bool>& use) {
  std::vector<Index> rows;
  for (std::size_t l = 0; l < use.size(); ++l) {
    if (use[l]) rows.push_back(static_cast<Index>(l));
  }
  Target used = target;
  used.s = target.s(rows);
  used.H = target.H(rows, Eigen::all);
  used.variance = target.variance(rows, Eigen::all);
  used.weight = used.s.cwiseAbs2();
  return used;
}

// A factor of exp(5) either way: the data say nothing of the parameter.
constexpr double most_variance = 25.0;
// Standard errors from where the data want the parameters, beyond which a fit
// that no longer moves has not arrived but is held by lambda.
constexpr double arrived = 0.3;

// Jacobian and covariance over all of pack(), zero where nothing was fitted.
// How far lambda holds the parameters from the least squares,
//
//   b = -J^+ r,
//
// is a bias that belongs to their uncertainty: C + b b'.
// @return the length of b in standard errors, a parameter's mean
double look_back(const Target& used,
                 const FrfModel& model,
                 const std::vector<Index>& fitted,
                 UpdateResult& result) {
  if (used.s.size() == 0 || fitted.empty()) return 0.0;
  const ModelResponse response = model.respond(result.state, used.s, true);
  result.residual = stack(used, response.H - used.H);
  const auto all = static_cast<Index>(response.dH.size());
  result.jacobian = MatrixXd::Zero(result.residual.size(), all);
  for (const Index k : fitted) {
    result.jacobian.col(k) =
        stack(used, response.dH[static_cast<std::size_t>(k)]);
  }
  const MatrixXd J = result.jacobian(Eigen::all, fitted);
  const VectorXd no_prior =
      VectorXd::Constant(J.cols(), std::numeric_limits<double>::infinity());
  MatrixXd own = parameter_covariance(used, J, result.residual, no_prior);
  const VectorXd bias =
      -J.completeOrthogonalDecomposition().solve(result.residual);
  const double apart = std::sqrt(std::max(
      bias.dot(own.ldlt().solve(bias)) / static_cast<double>(J.cols()), 0.0));
  own += bias * bias.transpose();
  for (Index k = 0; k < own.rows(); ++k) {
    const double shrink = std::sqrt(std::min(1.0, most_variance / own(k, k)));
    own.row(k) *= shrink;
    own.col(k) *= shrink;
  }
  result.covariance = MatrixXd::Zero(all, all);
  result.covariance(fitted, fitted) = own;
  return apart;
}

// Theta as pack() orders it, from the plain updater's P: the properties' own
// factors, and what effects were multiplied with.
VectorXd theta_of(const ModelState& start,
                  const std::vector<Index>& packed,
                  const VectorXd& P) {
  VectorXd theta = pack(start);
  const auto factors = static_cast<Index>(start.factor.size());
  for (Index k = 0; k < P.size(); ++k) {
    const Index at = packed[static_cast<std::size_t>(k)];
    theta(at) = std::log(P(k)) + (at < factors ? 0.0 : theta(at));
  }
  return theta;
}

std::vector<UpdateStep> history_of(const PlainResult& plain,
                                   const ModelState& start) {
  const double first = std::max(plain.misfit(0), 1e-300);
  std::vector<UpdateStep> history;
  for (Index n = 0; n < plain.history.rows(); ++n) {
    UpdateStep step;
    step.error = plain.misfit(n) / first;
    step.theta =
        theta_of(start, plain.packed, plain.history.row(n).transpose());
    if (n > 0) {
      step.length = (plain.history.row(n) - plain.history.row(n - 1))
                        .cwiseAbs()
                        .maxCoeff();
      step.lambda = plain.lambda[static_cast<std::size_t>(n) - 1];
    }
    history.push_back(std::move(step));
  }
  return history;
}

// Each measured ratio goes to the mode of the model nearest in frequency.
void take_damping(const PlainTask& task,
                  const FrfModel& model,
                  ModelState& state) {
  const VectorXd hz = model.base_modes(state).omega.head(state.zeta.size()) /
                      (2.0 * std::numbers::pi);
  const Index known =
      std::min(task.damping_ratio.size(), task.options.measured_hz.size());
  if (hz.size() == 0) return;
  for (Index k = 0; k < known; ++k) {
    Index nearest = 0;
    (hz.array() - task.options.measured_hz(k)).abs().minCoeff(&nearest);
    state.zeta(nearest) = task.damping_ratio(k);
  }
}

// Which of the effects' parameters no structure can have, if any.
std::string out_of_range(const FrfModel& model, const ModelState& state) {
  for (const EffectInstance& effect : state.effects) {
    const auto specs = parameters_of(effect, model);
    for (std::size_t k = 0; k < specs.size(); ++k) {
      const double p = effect.p[k];
      if (p >= specs[k].lower && p <= specs[k].upper) continue;
      return fmt::format("{} is {:.3g}, outside of {:.3g} to {:.3g}",
                         specs[k].name,
                         p,
                         specs[k].lower,
                         specs[k].upper);
    }
  }
  return {};
}

// What a fit from one start comes to.
struct Trial {
  UpdateResult result;
  Target used;                // lines
  std::vector<Index> fitted;  // in pack()
};

double error_of(const Fitter& fitter,
                const FrfModel& model,
                const ModelState& state) {
  const Target& report = fitter.target();
  return relative_error(report, model.respond(state, report.s, false).H);
}

// In place of what the fit found, and standard errors with it.
void keep(const ModelState& state,
          double error,
          const FrfModel& model,
          Trial& trial) {
  trial.result.converged = false;
  trial.result.state = state;
  trial.result.error = error;
  static_cast<void>(look_back(trial.used, model, trial.fitted, trial.result));
}

Trial fit_from(ModelState first,
               const Fitter& fitter,
               const PlainTask& task,
               const FrfModel& model) {
  take_damping(task, model, first);
  const PlainResult plain =
      plain_update(model, task.target, first, task.options);
  Trial trial{{}, used_lines(task.target, plain.use), plain.packed};
  UpdateResult& result = trial.result;
  result.converged = plain.converged;
  result.message = plain.message;
  result.history = history_of(plain, first);
  if (!plain.lambda.empty()) result.l_curve = plain.first_l_curve;
  result.state = plain.state;
  result.error = error_of(fitter, model, plain.state);
  const double apart = look_back(trial.used, model, trial.fitted, result);
  if (result.converged && apart > arrived) {
    result.converged = false;
    result.message = fmt::format(
        "held by lambda {:.2g} standard errors from where the data want the "
        "parameters: try a smaller --lambda",
        apart);
  }
  const double before = error_of(fitter, model, first);
  std::string fault = out_of_range(model, result.state);
  if (fault.empty() && !(result.error <= before)) {
    fault = fmt::format(
        "the error on the damped lines, {:.3g}, is above the start's {:.3g}",
        result.error,
        before);
  }
  if (fault.empty()) return trial;
  result.message += fmt::format(", where {}: the start is kept", fault);
  keep(first, before, model, trial);
  return trial;
}

}  // namespace

PlainTask plain_task(const UpdateChoice& choice,
                     const MeasuredTest& test,
                     const KnownLines& known,
                     const Progress& progress) {
  PlainTask task;
  // Regularised steps shorten slowly.
  task.options.max_iterations = 50;
  task.options.lambda = choice.lambda;
  // What the mesh does to the modes is nothing that the data alone would tell
  // from stiffness.
  task.options.properties = test.context.bundle->uncertain.size();
  VectorXd& peaks = task.options.measured_hz;
  peaks.resize(static_cast<Index>(test.modes.modes.size()));
  task.damping_ratio.resize(peaks.size());
  for (Index k = 0; k < peaks.size(); ++k) {
    const modal::Mode& mode = test.modes.modes[static_cast<std::size_t>(k)];
    peaks(k) = mode.frequency_hz;
    task.damping_ratio(k) = std::clamp(mode.damping_ratio, 1e-5, 0.5);
  }
  if (choice.lines.kind == LineKind::Damped) {
    task.target = known.report;
    task.lines = known.contour;
    return task;
  }
  task.options.rule = gaps_of(choice.lines, peaks);
  const VectorXd hz = lines_of(
      choice.lines, {test.context.low_hz, test.context.high_hz}, peaks);
  // With the FRFs' own window, which the model takes part in.
  Eigen::VectorXcd s(hz.size());
  s.real().setConstant(known.sigma);
  s.imag() = 2.0 * std::numbers::pi * hz;
  task.target = make_target(test.measurement.frfs_on(s, progress));
  task.lines = fmt::format("{}: {} lines from {:.4g} to {:.4g} Hz",
                           choice.lines.text,
                           hz.size(),
                           hz(0),
                           hz(hz.size() - 1));
  return task;
}

Fit plain_fit(const Fitter& fitter,
              const PlainTask& task,
              const std::vector<EffectInstance>& start,
              std::shared_ptr<const FrfModel> model,
              const Fit& before) {
  const auto from = [&](const Fit* properties) {
    return fit_from(
        fitter.start_state(*model, start, properties), fitter, task, *model);
  };
  Trial trial = from(nullptr);
  if (const auto known = fitter.continued(*model, start, before)) {
    const double limit = error_of(fitter, *model, *known);
    if (!(trial.result.error <= limit)) {
      Trial again = from(&before);
      if (again.result.error < trial.result.error) trial = std::move(again);
    }
    if (!(trial.result.error <= limit)) {
      trial.result.message +=
          "; the model before leaves less on the damped lines: it is kept";
      keep(*known, limit, *model, trial);
    }
  }
  return {trial.result.state.effects, trial.result, std::move(model)};
}

}  // namespace tapfit::updating
