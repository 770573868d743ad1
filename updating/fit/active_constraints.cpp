#include "updating/fit/active_constraints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

// Fitted in its logarithm, so that is where it has its prior.
void add_held_by_prior(const std::vector<PropertyName>& properties,
                       const std::vector<Estimate>& parameters,
                       std::vector<std::string>& held) {
  constexpr double far = 2.0;
  for (const PropertyName& property : properties) {
    const auto found =
        std::ranges::find(parameters, property.name, &Estimate::name);
    if (found == parameters.end() || !(found->value > 0.0)) continue;
    const double away =
        std::log(found->value / property.nominal) / property.prior_sd;
    if (!(std::abs(away) >= far)) continue;
    held.push_back(fmt::format(
        "{} ended {:.1f} standard deviations of its prior {} the model's "
        "value (`sd_percent` {:g} in test.json holds it)",
        property.name,
        std::abs(away),
        away > 0.0 ? "above" : "below",
        100.0 * property.prior_sd));
  }
}

void add_at_bound(const std::vector<Estimate>& parameters,
                  std::vector<std::string>& held) {
  for (const Estimate& e : parameters) {
    if (!e.at_bound) continue;
    const bool low = e.value - e.lo95 < e.hi95 - e.value;
    held.push_back(fmt::format("{} ended at its {} bound, {:.4g}",
                               e.name,
                               low ? "lower" : "upper",
                               e.value));
  }
}

}  // namespace

std::vector<std::string> active_constraints(
    const std::vector<PropertyName>& properties,
    const std::vector<Estimate>& parameters) {
  std::vector<std::string> held;
  add_held_by_prior(properties, parameters, held);
  add_at_bound(parameters, held);
  return held;
}

std::string what_is_left(const std::vector<std::string>& held) {
  return fmt::format("{}{}something else is missing",
                     fmt::join(held, "; "),
                     held.empty() ? "" : "; or ");
}

}  // namespace tapfit::updating
