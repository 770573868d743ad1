#include "tui/commands/update_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/commands/commands.hpp"
#include "tui/commands/compare_command.hpp"
#include "tui/commands/diagnose_command.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/effect_output.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/update_output.hpp"
#include "updating/diagnosis/named_diagnosis.hpp"
#include "updating/diagnosis/set_up_mistakes.hpp"
#include "updating/fit/active_constraints.hpp"
#include "updating/fit/fit_problem.hpp"
#include "updating/session/effect_change.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

namespace {

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
  std::vector<std::string> held = updating::active_constraints(
      updating::property_names(session.bundle(), session.deck(progress)),
      parameters);
  if (!records.empty() && !records.back().converged) {
    const auto& last = records.back();
    held.push_back(fmt::format("the fit of {} did not arrive ({})",
                               effect_text(last.added, last.where),
                               last.message));
  }
  updating::Diagnosis diagnosis = updating::diagnosis_of_named(
      session.ladder(progress), session.comparison(progress), parameters, held);
  diagnosis.model_form = session.model_form(progress);
  diagnosis.set_up =
      updating::set_up_mistakes(diagnosis.ladder, session.bundle());
  for (const auto& mistake : diagnosis.set_up) {
    diagnosis.warnings.push_back(describe(mistake));
  }
  const auto outliers = session.run_outliers(progress);
  diagnosis.set_up.insert(
      diagnosis.set_up.end(), outliers.begin(), outliers.end());
  if (std::string twice = updating::counted_twice({}, effects);
      !twice.empty()) {
    diagnosis.warnings.push_back(std::move(twice));
  }
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
    return json_text(json);
  }
  return pairs_text(session.comparison(progress).pairs) +
         updates_text(records) +
         fmt::format("Effects added: {}\n", added_text(diagnosis)) +
         findings_text(diagnosis);
}

}  // namespace tapfit::tui
