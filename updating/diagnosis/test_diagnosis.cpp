#include "updating/diagnosis/test_diagnosis.hpp"

#include "acquisition/bundle/channel_names.hpp"
#include "modal/mass_loading/sensor_shifts.hpp"
#include "modal/mass_loading/stated_masses.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/diagnosis/card_swap.hpp"
#include "updating/diagnosis/diagnose.hpp"
#include "updating/diagnosis/set_up_mistakes.hpp"
#include "updating/fit/corrected_model.hpp"
#include "updating/fit/fit_observer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {

DiagnoseOptions options_of_test(const FitContext& ground,
                                const Comparison& base) {
  DiagnoseOptions options;
  options.floor = std::hypot(base.floor_noise, base.floor_mesh);
  options.floor_noise = base.floor_noise;
  options.contour = base.contour;
  options.properties = ground.properties;
  return options;
}

std::string with_named(const std::string& named, const std::string& verdict) {
  if (named.empty() || verdict == "unexplained") return verdict;
  return verdict == "none" ? named : named + "+" + verdict;
}

TwofoldDiagnosis cut_at_deck(Diagnosis diagnosis,
                             const effects::TestContext& context) {
  TwofoldDiagnosis result;
  std::vector<Rung>& ladder = diagnosis.ladder;
  while (!ladder.empty()) {
    const effects::Effect& effect = effects::find(leading_kind(ladder.front()));
    if (!effect.corrects_deck()) break;
    result.named += (result.named.empty() ? "" : "+") + effect.name();
    result.corrections.push_back(placed(effect, ladder.front().where, context));
    ladder.erase(ladder.begin());
  }
  std::string& verdict = diagnosis.verdict;
  if (!result.named.empty() && verdict.starts_with(result.named)) {
    verdict.erase(0, std::min(verdict.size(), result.named.size() + 1));
    if (verdict.empty()) verdict = "none";
  }
  result.rest = std::move(diagnosis);
  return result;
}

namespace {

// What is missing from the deck once a number is put right: that comes first.
Diagnosis with_deck_put_right(const Diagnosis& as_written,
                              const SetUpMistake& slip,
                              const Comparison& base,
                              const MeasuredTest& test,
                              const DiagnoseOptions& options,
                              const Progress& progress) {
  const effects::Effect& effect = effects::find(slip.mistake);
  const std::vector<EffectInstance> corrections = {
      placed(effect, slip.where, test.context)};
  const auto right = correct_model(test, corrections, progress);
  DiagnoseOptions there = options_of_test(right->ground, base);
  there.tried = options.tried;
  Diagnosis d = diagnose(*right->ground.fitter, corrections, there, progress);
  Rung rung;
  rung.added = slip.mistake;
  rung.where = slip.where;
  rung.error = d.error_fitted;
  rung.probability = slip.probability;
  d.ladder.insert(d.ladder.begin(), rung);
  Candidate lead;
  lead.effect = slip.mistake;
  lead.where = slip.where;
  lead.probability = slip.probability;
  lead.error = d.error_best;
  d.candidates.insert(d.candidates.begin(), lead);
  d.set_up.insert(d.set_up.begin(), slip);
  d.warnings.insert(d.warnings.begin(), describe(slip));
  d.verdict = with_named(slip.mistake, d.verdict);
  d.error_base = as_written.error_base;
  d.error_fitted = as_written.error_fitted;
  return d;
}

}  // namespace

Diagnosis diagnose_test(const FitContext& ground,
                        const Fit& current,
                        const Comparison& base,
                        const MeasuredTest& test,
                        const std::vector<std::string>& of_model,
                        const Progress& progress) {
  DiagnoseOptions options = options_of_test(ground, base);
  if (const FitObserver* observer = fit_observer(progress)) {
    options.tried = observer->tried;
  }
  Diagnosis d = diagnose(*ground.fitter, current.effects, options, progress);
  if (current.effects.empty()) {
    if (const auto slip = card_swap(*ground.fitter, d, options, progress)) {
      d = with_deck_put_right(d, *slip, base, test, options, progress);
    }
  }
  // Nothing fitted yet: the base is the deck as it is.
  if (current.result.history.empty()) d.error_base = base.error;
  if (const auto& shifts = test.modes.shifts; modal::is_significant(shifts)) {
    d.warnings.push_back(modal::statement(
        *shifts, acquisition::channel_names(*test.context.bundle)));
  }
  const acquisition::TestBundle& bundle = *test.context.bundle;
  for (const Finding& off :
       modal::stated_mass_findings(bundle, test.modes.shifts)) {
    d.warnings.push_back(off.where.channel + ": " + in_full(off));
  }
  for (const Finding& off : sensor_mass_findings(d, bundle)) {
    d.warnings.push_back(off.where.channel + ": " + in_full(off));
  }
  for (const std::string& warning : of_model) {
    if (std::ranges::count(d.warnings, warning) > 0) continue;
    d.warnings.push_back(warning);
  }
  return d;
}

}  // namespace tapfit::updating
