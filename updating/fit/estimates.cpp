#include "updating/fit/estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

// theta is a logarithm: the interval is symmetric there.
Estimate from_log(const std::string& name, double value, double variance) {
  const double sd = std::sqrt(std::max(variance, 0.0));
  return {name,
          value,
          value * sd,
          value * std::exp(-1.96 * sd),
          value * std::exp(1.96 * sd)};
}

// Data that say nothing of a parameter leave it anywhere in its bounds, not
// beyond.
void within_bounds(Estimate& e, double lower, double upper) {
  lower = std::min(lower, e.value);
  upper = std::max(upper, e.value);
  constexpr double close = 1e-6;
  e.at_bound =
      std::min(e.value - lower, upper - e.value) <= close * std::abs(e.value) &&
      lower < upper;
  e.lo95 = std::max(e.lo95, lower);
  e.hi95 = std::min(e.hi95, upper);
  e.sd = std::min(e.sd, 0.5 * (upper - lower));
}

void turn_sign(Estimate& e) {
  e.value = -e.value;
  const double low = -e.hi95;
  e.hi95 = -e.lo95;
  e.lo95 = low;
}

// What is not known of an effect's place counts as independent of all else.
double place_sd(const EffectInstance& placed, std::size_t k) {
  return k < placed.place_sd.size() ? placed.place_sd[k] : 0.0;
}

// A sum of parameters is a logarithm's exponential too, to first order.
Estimate sum_of(const effects::Effect::Derived& derived,
                const EffectInstance& placed,
                const std::vector<effects::ParameterSpec>& specs,
                const Fit& fit,
                std::size_t first) {
  const auto n = static_cast<Eigen::Index>(placed.p.size());
  const Eigen::Map<const Eigen::VectorXd> p(placed.p.data(), n);
  const Eigen::Map<const Eigen::VectorXd> factors(derived.factors.data(), n);
  const double value = factors.dot(p);
  const Eigen::VectorXd share = factors.cwiseProduct(p) / value;
  const Eigen::MatrixXd& all = fit.result.covariance;
  const auto at = static_cast<Eigen::Index>(first);
  double variance =
      at + n <= all.rows() ? share.dot(all.block(at, at, n, n) * share) : 0.0;
  double with_place = 0.0;  // all sizes change with it together
  for (Eigen::Index k = 0; k < n; ++k) {
    with_place += share(k) * place_sd(placed, static_cast<std::size_t>(k));
  }
  variance += with_place * with_place;
  Estimate sum = from_log(derived.name, value, variance);
  double lower = 0.0;
  double upper = 0.0;
  for (std::size_t k = 0; k < specs.size(); ++k) {
    lower += derived.factors[k] * specs[k].lower;
    upper += derived.factors[k] * specs[k].upper;
  }
  within_bounds(sum, lower, upper);
  return sum;
}

double variance_at(const Fit& fit, std::size_t k) {
  const auto at = static_cast<Eigen::Index>(k);
  const Eigen::MatrixXd& c = fit.result.covariance;
  return at < c.rows() ? c(at, at) : 0.0;
}

}  // namespace

std::string label_of(const std::vector<EffectInstance>& effects,
                     std::size_t own) {
  const EffectInstance& placed = effects.at(own);
  const auto kind =
      std::ranges::count(effects, placed.effect, &EffectInstance::effect);
  const std::string name = placed.effect->name();
  return kind > 1 ? fmt::format("{} ({})", name, describe(placed.where)) : name;
}

std::vector<Estimate> effect_estimates(const Fit& fit,
                                       std::size_t effect,
                                       const effects::TestContext& context) {
  const ModelState& state = fit.result.state;
  std::size_t at =
      state.factor.size() + static_cast<std::size_t>(state.zeta.size());
  for (std::size_t e = 0; e < effect; ++e) at += state.effects[e].p.size();
  const EffectInstance& placed = state.effects[effect];
  const std::vector<effects::ParameterSpec> specs =
      parameters_of(placed, *fit.model);
  std::vector<Estimate> result;
  for (const effects::Effect::Derived& derived :
       placed.effect->derived(placed.where, context)) {
    result.push_back(sum_of(derived, placed, specs, fit, at));
  }
  for (const auto& [name, value] : placed.effect->fixed(placed.where)) {
    result.push_back({name, value, 0.0, value, value});
  }
  for (std::size_t k = 0; k < specs.size(); ++k) {
    const double own = place_sd(placed, k);
    result.push_back(from_log(
        specs[k].name, placed.p[k], variance_at(fit, at + k) + own * own));
    within_bounds(result.back(), specs[k].lower, specs[k].upper);
    if (specs[k].sign < 0.0) turn_sign(result.back());
  }
  return result;
}

std::vector<Estimate> property_estimates(
    const Fit& fit, const std::vector<PropertyName>& names) {
  std::vector<Estimate> result;
  const ModelState& state = fit.result.state;
  for (std::size_t k = 0; k < state.factor.size() && k < names.size(); ++k) {
    Estimate e = from_log(
        names[k].name, state.factor[k] * names[k].nominal, variance_at(fit, k));
    e.unit = names[k].unit;
    result.push_back(e);
  }
  return result;
}

std::vector<Estimate> all_estimates(const Fit& fit,
                                    const std::vector<PropertyName>& names,
                                    const effects::TestContext& context) {
  std::vector<Estimate> result = property_estimates(fit, names);
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    for (Estimate e : effect_estimates(fit, k, context)) {
      e.name = label_of(fit.effects, k) + " " + e.name;
      result.push_back(std::move(e));
    }
  }
  return result;
}

std::vector<Rung> rungs_of(const std::vector<Fit>& fits,
                           const effects::TestContext& context) {
  std::vector<Rung> ladder;
  for (const Fit& fit : fits) {
    Rung rung;
    rung.added = ladder.empty() ? base_rung : uncertain_rung;
    rung.error = fit.result.error;
    rung.stopped_after = fit.stopped_after;
    if (!fit.effects.empty()) {
      const std::size_t last = fit.effects.size() - 1;
      rung.added = fit.effects[last].effect->name();
      rung.where = fit.effects[last].where;
      rung.parameters = effect_estimates(fit, last, context);
    }
    ladder.push_back(std::move(rung));
  }
  return ladder;
}

}  // namespace tapfit::updating
