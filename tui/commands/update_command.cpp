#include "tui/commands/update_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/commands/compare_command.hpp"
#include "tui/commands/diagnose_command.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/effect_output.hpp"
#include "tui/report/update_output.hpp"
#include "updating/fit/fit_setting.hpp"
#include "updating/fit/held_back.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>

namespace tapfit::tui {

namespace {

/// Gives the candidates the values that all effects together have and the error
/// that these leave, and leaves the base's own parameters: the session names an
/// effect's "EFFECT NAME".
void take_final_values(updating::Diagnosis& diagnosis) {
  auto& parameters = diagnosis.model_parameters;
  for (auto& candidate : diagnosis.candidates) {
    candidate.error = diagnosis.error_best;
    for (auto& estimate : candidate.parameters) {
      const auto found =
          std::ranges::find(parameters,
                            candidate.effect + " " + estimate.name,
                            &updating::Estimate::name);
      if (found == parameters.end()) continue;
      const std::string name = estimate.name;
      estimate = *found;
      estimate.name = name;
      parameters.erase(found);
    }
  }
}

/// Named or not: an effect that explains nothing is no verdict.
void name_what_helps(updating::Diagnosis& diagnosis) {
  double before = diagnosis.error_fitted;
  for (const auto& rung : diagnosis.ladder) {
    if (rung.error < updating::worth_it * before) {
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

/// What was named, whether it explains anything or not.
std::string added_text(const updating::Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const auto& rung : diagnosis.ladder) names.push_back(rung.added);
  if (names.empty()) return "none";
  std::string text = fmt::format("{}", fmt::join(names, "+"));
  if (diagnosis.verdict != text) {
    text += fmt::format("; verdict {}", diagnosis.verdict);
  }
  return text;
}

}  // namespace

updating::Diagnosis diagnosis_of_named(
    const std::vector<updating::Rung>& ladder,
    const updating::Comparison& comparison,
    const std::vector<updating::Estimate>& model_parameters,
    const std::vector<std::string>& held) {
  assert(!ladder.empty());
  updating::Diagnosis diagnosis;
  // The base, what is uncertain in it, then the effects.
  for (const updating::Rung& rung : ladder) {
    const bool effect = rung.added != updating::base_rung &&
                        rung.added != updating::uncertain_rung;
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
                    updating::what_is_left(held)));
  }
  return diagnosis;
}

updating::UpdateChoice update_choice(const CommandOptions& options) {
  updating::UpdateChoice choice;
  choice.lines = updating::parse_lines(options.lines);
  choice.l_curve = options.lambda == "l-curve";
  if (!options.lambda.empty() && !choice.l_curve) {
    choice.lambda = std::stod(options.lambda);
  }
  return choice;
}

std::string update_command(const CommandOptions& options,
                           const Progress& progress) {
  std::vector<updating::EffectRef> effects;
  for (const auto& text : options.effects) {
    effects.push_back(updating::parse_effect(text));
  }
  updating::Session session = open_by_hand(options, progress);
  if (effects.empty() && session.bundle().uncertain.empty()) {
    throw InputError("there is nothing to identify",
                     options.input,
                     "name an --effect, or list in test.json what is "
                     "`uncertain` in the model");
  }
  session.set_update(update_choice(options));
  session.fit_uncertain(progress);
  for (const auto& effect : effects) session.add(effect, progress);
  const auto records = session.update_records(progress);
  const auto parameters = session.model_parameters(progress);
  std::vector<std::string> held = updating::held_back(
      updating::property_names(session.bundle(), session.deck(progress)),
      parameters);
  if (!records.empty() && !records.back().converged) {
    const auto& last = records.back();
    held.push_back(fmt::format("the fit of {} did not arrive ({})",
                               effect_text(last.added, last.where),
                               last.message));
  }
  updating::Diagnosis diagnosis = diagnosis_of_named(
      session.ladder(progress), session.comparison(progress), parameters, held);
  const auto loose = session.model_warnings(progress);
  diagnosis.warnings.insert(
      diagnosis.warnings.end(), loose.begin(), loose.end());
  for (const auto& record : records) {
    if (record.converged) continue;
    diagnosis.warnings.push_back(fmt::format(
        "{}: {}", effect_text(record.added, record.where), record.message));
  }
  if (options.json) {
    nlohmann::ordered_json json =
        diagnosis_json(options.input, with_input_warnings(diagnosis, session));
    json["updates"] = updates_json(records);
    return json.dump(2) + "\n";
  }
  return pairs_text(session.comparison(progress).pairs) +
         updates_text(records) +
         fmt::format("Effects added: {}\n", added_text(diagnosis)) +
         findings_text(diagnosis);
}

}  // namespace tapfit::tui
