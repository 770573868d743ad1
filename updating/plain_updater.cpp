#include "updating/plain_updater.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Linearised {
  MatrixXd S;
  VectorXd delta;
};

class PlainProblem {
 public:
  PlainProblem(const FrfModel& model,
               const Target& target,
               const PlainOptions& options)
      : model_(model),
        target_(target),
        options_(options),
        weight_(target.H.rows(), target.H.cols()) {
    // Receptance is accelerance over s^2.
    weight_.colwise() = target.s.cwiseAbs2().cwiseInverse();
    if (options.by_scatter)
      weight_ = target.variance.cwiseSqrt().cwiseInverse();
  }

  [[nodiscard]] Linearised at(const ModelState& state) const {
    const ModelResponse response = model_.respond(state, target_.s, true);
    const std::vector<bool> use = lines(state);
    Linearised system;
    system.delta = stacked(target_.H - response.H, use);
    const auto n = static_cast<Index>(state.factor.size());
    system.S.resize(system.delta.size(), n);
    for (Index k = 0; k < n; ++k) {
      const auto j = static_cast<std::size_t>(k);
      // d / d ln f to d / d f
      system.S.col(k) = stacked(response.dH[j], use) / state.factor[j];
    }
    return system;
  }

 private:
  [[nodiscard]] std::vector<bool> lines(const ModelState& state) const {
    const auto count = static_cast<std::size_t>(target_.s.size());
    if (!options_.rule) return std::vector<bool>(count, true);
    const double two_pi = 2.0 * std::numbers::pi;
    return off_peaks(target_.s.imag() / two_pi,
                     options_.measured_hz,
                     model_.base_modes(state).omega / two_pi,
                     *options_.rule);
  }

  // Real parts, then imaginary ones, of the lines in use.
  [[nodiscard]] VectorXd stacked(const MatrixXcd& H,
                                 const std::vector<bool>& use) const {
    std::vector<Index> rows;
    for (std::size_t l = 0; l < use.size(); ++l) {
      if (use[l]) rows.push_back(static_cast<Index>(l));
    }
    const MatrixXcd chosen = H.cwiseProduct(weight_)(rows, Eigen::all);
    VectorXd r(2 * chosen.size());
    r << chosen.reshaped().real(), chosen.reshaped().imag();
    return r;
  }

  const FrfModel& model_;
  const Target& target_;
  const PlainOptions& options_;
  MatrixXd weight_;  // lines x FRFs
};

bool is_sound(const Linearised& system) {
  return system.delta.size() >= system.S.cols() && system.delta.allFinite() &&
         system.S.allFinite();
}

void record(const ModelState& state, double misfit, PlainResult& result) {
  const Index row = result.history.rows();
  result.history.conservativeResize(row + 1,
                                    static_cast<Index>(state.factor.size()));
  for (std::size_t k = 0; k < state.factor.size(); ++k) {
    result.history(row, static_cast<Index>(k)) = state.factor[k];
  }
  result.misfit.conservativeResize(row + 1);
  result.misfit(row) = misfit;
}

}  // namespace

PlainResult plain_update(const FrfModel& model,
                         const Target& target,
                         const ModelState& start,
                         const PlainOptions& options) {
  const PlainProblem problem(model, target, options);
  PlainResult result;
  result.state = start;
  Linearised system = problem.at(start);
  record(start, system.delta.norm(), result);
  for (int n = 0; n < options.max_iterations && !result.converged; ++n) {
    if (!is_sound(system)) {
      result.message = "no line is left to compare";
      return result;
    }
    const TikhonovSystem solver(system.S, system.delta);
    result.l_curve = solver.l_curve();
    const VectorXd step = solver.solve(
        options.lambda.value_or(result.l_curve.lambda(result.l_curve.corner)));
    ModelState next = result.state;
    for (std::size_t k = 0; k < next.factor.size(); ++k) {
      next.factor[k] += step(static_cast<Index>(k));
    }
    if (!step.allFinite() ||
        std::ranges::any_of(next.factor, [](double f) { return !(f > 0.0); })) {
      result.message =
          fmt::format("diverged in step {}: a property became negative", n + 1);
      return result;
    }
    result.state = std::move(next);
    system = problem.at(result.state);
    record(result.state, system.delta.norm(), result);
    result.converged = step.norm() <= options.tolerance;
  }
  if (is_sound(system)) result.identifiability = identifiability(system.S);
  result.message = result.converged ? "converged"
                                    : fmt::format("not converged in {} steps",
                                                  options.max_iterations);
  return result;
}

}  // namespace tapfit::updating
