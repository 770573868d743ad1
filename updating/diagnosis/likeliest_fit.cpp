#include "updating/diagnosis/likeliest_fit.hpp"

#include "updating/fit/fitted_form.hpp"

#include <algorithm>
#include <optional>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A fit's parameters, and what is known of the likelihood there.
struct Point {
  VectorXd theta;
  double log_posterior = 0.0;  // with the parameters as they are
  VectorXd step;               // to where it would be largest
};

std::optional<Point> look(const Fit& fit,
                          const VectorXd& theta,
                          const Target& target,
                          const Judgement& judgement) {
  UpdateResult result = fit.result;
  result.state = unpack(fit.result.state, theta);
  const ModelResponse response =
      fit.model->respond(result.state, target.s, true);
  if (!response.H.allFinite()) return std::nullopt;
  const VectorXd r = residual(target, response.H);
  result.jacobian.resize(r.size(), theta.size());
  for (std::size_t k = 0; k < response.dH.size(); ++k) {
    result.jacobian.col(static_cast<Index>(k)) = stack(target, response.dH[k]);
  }
  const Readjustment free = readjustment(result);
  const FormError form = form_error(*fit.model, result.state, target);
  const double prior_cost =
      prior_residuals(result.prior, theta).r.squaredNorm();
  const auto estimate = [&](const Readjustment& fitted) {
    FormView seen = view(form, r, fitted);
    seen.allowance = fit.form.allowance;
    return estimate_form(seen, judgement.data, judgement.noise);
  };
  return Point{theta,
               estimate({}).log_likelihood - 0.5 * prior_cost,
               estimate(free).step};
}

}  // namespace

Fit likeliest_fit(const Fit& fit,
                  const Fitter& fitter,
                  const Judgement& judgement) {
  constexpr int most_steps = 6;
  constexpr double arrived = 0.01;  // of a parameter
  const Prior& prior = fit.result.prior;
  const Target& target = fitter.target();
  const VectorXd start = pack(fit.result.state);
  std::optional<Point> at = look(fit, start, target, judgement);
  double share = 1.0;
  for (int k = 0; at && k < most_steps && at->step.size() > 0; ++k) {
    const VectorXd step = share * at->step;
    if (step.cwiseAbs().maxCoeff() < arrived) break;
    const VectorXd next =
        (at->theta + step).cwiseMax(prior.lower).cwiseMin(prior.upper);
    std::optional<Point> tried = look(fit, next, target, judgement);
    if (tried && tried->log_posterior > at->log_posterior) {
      at = std::move(tried);
      share = 1.0;
    } else {
      share *= 0.4;
    }
  }
  Fit likeliest = fit;
  if (!at) return likeliest;
  likeliest.result.state = unpack(fit.result.state, at->theta);
  likeliest.effects = likeliest.result.state.effects;
  return likeliest;
}

}  // namespace tapfit::updating
