#include "updating/diagnosis/test_diagnosis.hpp"

#include "acquisition/bundle/channel_names.hpp"
#include "modal/mass_loading/sensor_shifts.hpp"
#include "modal/mass_loading/stated_masses.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/comparison/compare.hpp"
#include "updating/diagnosis/card_swap.hpp"
#include "updating/diagnosis/diagnose.hpp"
#include "updating/diagnosis/set_up_mistakes.hpp"
#include "updating/fit/corrected_model.hpp"
#include "updating/fit/fit_observer.hpp"
#include "updating/fit/overall_progress.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace tapfit::updating {

DiagnoseOptions options_of_test(const FitContext& ground) {
  DiagnoseOptions options;
  options.floor = std::hypot(ground.floor_noise, ground.floor_mesh);
  options.floor_noise = ground.floor_noise;
  options.contour = ground.contour;
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

std::unique_ptr<CorrectedModel> put_right(const SetUpMistake& slip,
                                          const MeasuredTest& test,
                                          const Progress& progress) {
  return correct_model(
      test,
      {placed(effects::find(slip.mistake), slip.where, test.context)},
      progress);
}

// What is missing from the deck once a number is put right: that comes first.
Diagnosis with_deck_put_right(const SetUpMistake& slip,
                              const CorrectedModel& right,
                              const DiagnoseOptions& as_written,
                              double error_as_written,
                              const Progress& progress) {
  DiagnoseOptions there = options_of_test(right.ground);
  there.tried = as_written.tried;
  Diagnosis d =
      diagnose(*right.ground.fitter, right.corrections, there, progress);
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
  d.error_base = error_as_written;
  d.error_fitted = error_as_written;
  return d;
}

// With the slip put right, where no effect by itself of the deck as it is comes
// near what that leaves; its floor is that of the deck put right, for a deck
// that is wrong has that of another structure.
std::optional<Diagnosis> put_right_at_once(const SetUpMistake& slip,
                                           const Fit& plain,
                                           const FitContext& ground,
                                           const MeasuredTest& test,
                                           const DiagnoseOptions& options,
                                           const Progress& progress) {
  const Fitter& fitter = *ground.fitter;
  const Progress first = part_of(progress, 0.0, 0.1);
  const auto right = put_right(slip, test, first);
  const double floor = options_of_test(right->ground).floor;
  const double left =
      fitter.settled(fitter.arrive(plain, first), first).result.error;
  // What its split mesh says of the deck put right goes with it.
  const auto mended = [&] {
    const Fitter& there = *right->ground.fitter;
    return there.settled(there.fit({}, there.model_for({}), first), first)
        .result.error;
  };
  if (!is_out_of_scale(slip, *test.context.deck) &&
      !explains_all(mended(), left, floor)) {
    DiagnoseOptions one = options;
    one.max_rungs = 1;
    const Diagnosis d = diagnose(fitter, {}, one, part_of(progress, 0.1, 0.5));
    if (!none_explains(d, floor) || !leaves_less(slip, d)) return std::nullopt;
  }
  return with_deck_put_right(
      slip, *right, options, left, part_of(progress, 0.5, 1.0));
}

// Of the deck as it is written, or put right where that does far better.
Diagnosis diagnose_deck(const FitContext& ground,
                        const MeasuredTest& test,
                        const DiagnoseOptions& options,
                        const Progress& progress) {
  const Fitter& fitter = *ground.fitter;
  const Progress first = part_of(progress, 0.0, 0.05);
  const Fit plain = fitter.approach({}, fitter.model_for({}), first).value();
  const bool at_once = may_be_slip(plain, fitter);
  if (at_once) {
    if (const auto slip = likely_slip(fitter, first)) {
      auto d = put_right_at_once(*slip, plain, ground, test, options, progress);
      if (d) return *std::move(d);
    }
  }
  Diagnosis d = diagnose(fitter, {}, options, part_of(progress, 0.05, 0.9));
  if (at_once || !none_explains(d, options.floor)) return d;
  const Progress last = part_of(progress, 0.9, 1.0);
  const auto slip = likely_slip(fitter, last);
  if (!slip || !leaves_less(*slip, d)) return d;
  const auto right = put_right(*slip, test, last);
  return with_deck_put_right(*slip, *right, options, d.error_fitted, last);
}

}  // namespace

Diagnosis diagnose_test(const FitContext& ground,
                        const Fit& current,
                        const Comparison& base,
                        const MeasuredTest& test,
                        const std::vector<std::string>& of_model,
                        const Progress& progress) {
  DiagnoseOptions options = options_of_test(ground);
  if (const FitObserver* observer = fit_observer(progress)) {
    options.tried = observer->tried;
  }
  Diagnosis d =
      current.effects.empty()
          ? diagnose_deck(ground, test, options, progress)
          : diagnose(*ground.fitter, current.effects, options, progress);
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
  // What hides behind the floor of the deck as written shows once it is right.
  const bool corrected = !cut_at_deck(d, test.context).corrections.empty();
  const std::string of_floor = corrected ? floor_warning(base) : "";
  for (const std::string& warning : of_model) {
    if (warning == of_floor) continue;
    if (std::ranges::count(d.warnings, warning) > 0) continue;
    d.warnings.push_back(warning);
  }
  return d;
}

}  // namespace tapfit::updating
