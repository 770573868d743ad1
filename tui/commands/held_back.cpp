#include "tui/commands/held_back.hpp"

#include "tui/commands/effect_output.hpp"
#include "updating/uncertain_property.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

namespace {

// Fitted in its logarithm, so that is where it has its prior.
void add_held_by_prior(const structure::Deck& deck,
                       const acquisition::TestBundle& bundle,
                       const std::vector<updating::Estimate>& parameters,
                       std::vector<std::string>& held) {
  constexpr double far = 2.0;
  for (const auto& uncertain : bundle.uncertain) {
    const updating::PropertyLaw law =
        updating::property_law(deck, uncertain, "test.json: uncertain");
    const auto found =
        std::ranges::find(parameters, law.name, &updating::Estimate::name);
    if (found == parameters.end() || !(found->value > 0.0)) continue;
    const double away =
        std::log(found->value / law.nominal) / (uncertain.sd_percent / 100.0);
    if (std::abs(away) < far) continue;
    held.push_back(fmt::format(
        "{} ended {:.1f} standard deviations of its prior {} the model's "
        "value (`sd_percent` {:g} in test.json holds it)",
        law.name,
        std::abs(away),
        away > 0.0 ? "above" : "below",
        uncertain.sd_percent));
  }
}

void add_at_bound(const std::vector<updating::Estimate>& parameters,
                  std::vector<std::string>& held) {
  for (const updating::Estimate& e : parameters) {
    if (!e.at_bound) continue;
    const bool low = e.value - e.lo95 < e.hi95 - e.value;
    held.push_back(fmt::format("{} ended at its {} bound, {:.4g}",
                               e.name,
                               low ? "lower" : "upper",
                               e.value));
  }
}

}  // namespace

std::vector<std::string> held_back(
    const structure::Deck& deck,
    const acquisition::TestBundle& bundle,
    const std::vector<updating::Estimate>& parameters,
    const std::vector<updating::UpdateRecord>& records) {
  std::vector<std::string> held;
  add_held_by_prior(deck, bundle, parameters, held);
  add_at_bound(parameters, held);
  if (!records.empty() && !records.back().converged) {
    held.push_back(
        fmt::format("the fit of {} did not arrive ({})",
                    effect_text(records.back().added, records.back().where),
                    records.back().message));
  }
  return held;
}

}  // namespace tapfit::tui
