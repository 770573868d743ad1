#include "updating/diagnosis/named_diagnosis.hpp"

#include "updating/fit/active_constraints.hpp"
#include "updating/search/screened.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace tapfit::updating {

namespace {

/// Gives the candidates the values that all effects together have and the error
/// that these leave, and leaves the base's own parameters: the session names an
/// effect's "EFFECT NAME".
void take_final_values(Diagnosis& diagnosis) {
  auto& parameters = diagnosis.model_parameters;
  for (auto& candidate : diagnosis.candidates) {
    candidate.error = diagnosis.error_best;
    for (auto& estimate : candidate.parameters) {
      const auto found = std::ranges::find(
          parameters, candidate.effect + " " + estimate.name, &Estimate::name);
      if (found == parameters.end()) continue;
      const std::string name = estimate.name;
      estimate = *found;
      estimate.name = name;
      parameters.erase(found);
    }
  }
}

/// Named or not: an effect that explains nothing is no verdict.
void name_what_helps(Diagnosis& diagnosis) {
  double before = diagnosis.error_fitted;
  for (const auto& rung : diagnosis.ladder) {
    if (rung.error < worth_it * before) {
      diagnosis.verdict += (diagnosis.verdict.empty() ? "" : "+") + rung.added;
    } else {
      diagnosis.warnings.push_back(
          fmt::format("{} does not explain what is missing: the error was "
                      "{:.3g} without it and is {:.3g} with it",
                      effect_text(rung.added, rung.where),
                      before,
                      rung.error));
    }
    before = rung.error;
  }
  if (!diagnosis.verdict.empty()) return;
  diagnosis.verdict =
      diagnosis.error_best <= 3.0 * diagnosis.floor ? "none" : "unexplained";
}

}  // namespace

Diagnosis diagnosis_of_named(const std::vector<Rung>& ladder,
                             const Comparison& comparison,
                             const std::vector<Estimate>& model_parameters,
                             const std::vector<std::string>& held) {
  assert(!ladder.empty());
  Diagnosis diagnosis;
  // The base, what is uncertain in it, then the effects.
  for (const Rung& rung : ladder) {
    const bool effect = rung.added != base_rung && rung.added != uncertain_rung;
    if (effect) {
      diagnosis.ladder.push_back(rung);
    } else {
      diagnosis.error_fitted = rung.error;
    }
  }
  diagnosis.error_base = ladder.front().error;
  diagnosis.error_best = ladder.back().error;
  diagnosis.floor = comparison.floor;
  diagnosis.contour = comparison.contour;
  diagnosis.model_parameters = model_parameters;
  for (const auto& rung : diagnosis.ladder) {
    diagnosis.candidates.push_back({.effect = rung.added,
                                    .where = rung.where,
                                    .parameters = rung.parameters,
                                    .probability = 1.0,
                                    .error = rung.error,
                                    .held_out_error = 0.0,
                                    .indistinguishable_from = {}});
  }
  take_final_values(diagnosis);
  name_what_helps(diagnosis);
  if (!diagnosis.ladder.empty()) {
    diagnosis.warnings.emplace_back(
        "the effects were named by the user and taken as given: the "
        "probabilities compare them with nothing");
  }
  if (diagnosis.error_best > 3.0 * diagnosis.floor) {
    diagnosis.warnings.push_back(
        fmt::format("an error of {:.3g} is left where the measurement supports "
                    "{:.3g}: {}",
                    diagnosis.error_best,
                    diagnosis.floor,
                    what_is_left(held)));
  }
  return diagnosis;
}

}  // namespace tapfit::updating
