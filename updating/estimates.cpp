#include "updating/estimates.hpp"

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
void within_bounds(Estimate& e,
                   const effects::ParameterSpec& spec,
                   double factor) {
  const double lower = std::min(spec.lower * factor, e.value);
  const double upper = std::max(spec.upper * factor, e.value);
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

double variance_at(const Fit& fit, std::size_t k) {
  const auto at = static_cast<Eigen::Index>(k);
  const Eigen::MatrixXd& c = fit.result.covariance;
  return at < c.rows() ? c(at, at) : 0.0;
}

}  // namespace

std::vector<Estimate> effect_estimates(const Fit& fit,
                                       std::size_t effect,
                                       const effects::Setting& setting) {
  const ModelState& state = fit.result.state;
  std::size_t at =
      state.factor.size() + static_cast<std::size_t>(state.zeta.size());
  for (std::size_t e = 0; e < effect; ++e) at += state.effects[e].p.size();
  const PlacedEffect& placed = state.effects[effect];
  std::vector<Estimate> result;
  for (const effects::Effect::Derived& d :
       placed.effect->derived(placed.where, setting)) {
    result.push_back(
        from_log(d.name, placed.p[0] * d.factor, variance_at(fit, at)));
  }
  std::vector<effects::ParameterSpec> specs =
      placed.effect->parameters(placed.where, setting);
  for (const StiffnessTerm& term : fit.model->base().terms) {
    if (!is_of(term, placed)) continue;
    specs.front().lower = term.lower;
    specs.front().upper = term.upper;
  }
  for (std::size_t k = 0; k < specs.size(); ++k) {
    result.push_back(
        from_log(specs[k].name, placed.p[k], variance_at(fit, at + k)));
    within_bounds(result.back(), specs[k], 1.0);
    if (specs[k].sign < 0.0) turn_sign(result.back());
    // Derived values stand before the parameter that they come from.
    for (std::size_t d = 0; k == 0 && d + 1 < result.size(); ++d) {
      within_bounds(result[d], specs[0], result[d].value / placed.p[0]);
    }
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
                                    const effects::Setting& setting) {
  std::vector<Estimate> result = property_estimates(fit, names);
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    for (Estimate e : effect_estimates(fit, k, setting)) {
      e.name = fit.effects[k].effect->name() + " " + e.name;
      result.push_back(std::move(e));
    }
  }
  return result;
}

std::vector<Rung> rungs_of(const std::vector<Fit>& fits,
                           const effects::Setting& setting) {
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
      rung.parameters = effect_estimates(fit, last, setting);
    }
    ladder.push_back(std::move(rung));
  }
  return ladder;
}

}  // namespace tapfit::updating
