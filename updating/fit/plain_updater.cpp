#include "updating/fit/plain_updater.hpp"

#include "acquisition/foundation/constants.hpp"

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
  std::vector<bool> use;  // lines
};

// The parameters P: properties over their nominal, effects' sizes over where
// they started.
class Parameters {
 public:
  Parameters(const ModelState& start, const PlainOptions& options)
      : start_(start),
        properties_(std::min(options.properties.value_or(start.factor.size()),
                             start.factor.size())) {
    count_ = static_cast<Index>(properties_);
    for (const EffectInstance& e : start.effects) {
      count_ += static_cast<Index>(e.p.size());
    }
  }

  [[nodiscard]] VectorXd first() const {
    VectorXd P = VectorXd::Ones(count_);
    std::copy_n(start_.factor.begin(), properties_, P.begin());
    return P;
  }

  [[nodiscard]] ModelState state(const VectorXd& P) const {
    ModelState state = start_;
    Index k = 0;
    for (std::size_t j = 0; j < properties_; ++j) state.factor[j] = P(k++);
    for (EffectInstance& e : state.effects) {
      for (double& p : e.p) p *= P(k++);
    }
    return state;
  }

  /// Position of P_k in pack(), where the damping ratios stand between.
  [[nodiscard]] std::size_t packed(Index k) const {
    const auto at = static_cast<std::size_t>(k);
    if (at < properties_) return at;
    return at - properties_ + start_.factor.size() +
           static_cast<std::size_t>(start_.zeta.size());
  }

 private:
  const ModelState& start_;
  std::size_t properties_;
  Index count_ = 0;
};

class PlainProblem {
 public:
  PlainProblem(const FrfModel& model,
               const Target& target,
               const Parameters& parameters,
               const PlainOptions& options)
      : model_(model),
        target_(target),
        parameters_(parameters),
        options_(options),
        weight_(target.H.rows(), target.H.cols()) {
    // Receptance is accelerance over s^2.
    weight_.colwise() = target.s.cwiseAbs2().cwiseInverse();
    if (options.by_scatter)
      weight_ = target.variance.cwiseSqrt().cwiseInverse();
  }

  [[nodiscard]] Linearised at(const VectorXd& P) const {
    const ModelState state = parameters_.state(P);
    const ModelResponse response = model_.respond(state, target_.s, true);
    Linearised system;
    system.use = lines(state);
    system.delta = stacked(target_.H - response.H, system.use);
    system.S.resize(system.delta.size(), P.size());
    for (Index k = 0; k < P.size(); ++k) {
      // d / d ln P to d / d P
      system.S.col(k) =
          stacked(response.dH[parameters_.packed(k)], system.use) / P(k);
    }
    return system;
  }

 private:
  [[nodiscard]] std::vector<bool> lines(const ModelState& state) const {
    const auto count = static_cast<std::size_t>(target_.s.size());
    if (!options_.rule) return std::vector<bool>(count, true);
    return off_peaks(target_.s.imag() / two_pi,
                     options_.measured_hz,
                     model_.full_modes(state).omega / two_pi,
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
  const Parameters& parameters_;
  const PlainOptions& options_;
  MatrixXd weight_;  // lines x FRFs
};

bool is_sound(const Linearised& system) {
  return system.delta.size() >= system.S.cols() && system.delta.allFinite() &&
         system.S.allFinite();
}

void record(const VectorXd& P, double misfit, PlainResult& result) {
  const Index row = result.history.rows();
  result.history.conservativeResize(row + 1, P.size());
  result.history.row(row) = P.transpose();
  result.misfit.conservativeResize(row + 1);
  result.misfit(row) = misfit;
}

// One step; false where there is none, with the reason in the result.
bool advance(const Linearised& system,
             const PlainOptions& options,
             VectorXd& P,
             PlainResult& result) {
  if (P.size() == 0) {
    result.message = "there is nothing to identify";
    return false;
  }
  if (!is_sound(system)) {
    result.message = "no line is left to compare";
    return false;
  }
  const TikhonovSystem solver(system.S, system.delta);
  result.l_curve = solver.l_curve();
  if (result.lambda.empty()) result.first_l_curve = result.l_curve;
  result.lambda.push_back(
      options.lambda.value_or(result.l_curve.lambda(result.l_curve.corner)));
  const VectorXd step = solver.solve(result.lambda.back());
  if (!step.allFinite() || (P + step).minCoeff() <= 0.0) {
    result.message =
        fmt::format("diverged in step {}: a parameter became negative",
                    result.lambda.size());
    result.lambda.pop_back();
    return false;
  }
  P += step;
  result.converged = step.norm() <= options.tolerance;
  return true;
}

}  // namespace

PlainResult plain_update(const FrfModel& model,
                         const Target& target,
                         const ModelState& start,
                         const PlainOptions& options) {
  const Parameters parameters(start, options);
  const PlainProblem problem(model, target, parameters, options);
  PlainResult result;
  VectorXd P = parameters.first();
  Linearised system = problem.at(P);
  record(P, system.delta.norm(), result);
  result.message =
      fmt::format("not converged in {} steps", options.max_iterations);
  for (int n = 0; n < options.max_iterations && !result.converged; ++n) {
    if (!advance(system, options, P, result)) break;
    system = problem.at(P);
    record(P, system.delta.norm(), result);
  }
  if (result.converged) result.message = "converged";
  for (Index k = 0; k < P.size(); ++k) {
    result.packed.push_back(static_cast<Index>(parameters.packed(k)));
  }
  result.state = parameters.state(P);
  if (P.size() > 0 && is_sound(system))
    result.identifiability = identifiability(system.S);
  result.use = std::move(system.use);
  return result;
}

}  // namespace tapfit::updating
