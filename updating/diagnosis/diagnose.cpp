#include "updating/diagnosis/diagnose.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/classify_diagnosis.hpp"
#include "updating/diagnosis/error_ladder.hpp"
#include "updating/diagnosis/likeliest_fit.hpp"
#include "updating/diagnosis/made_fit.hpp"
#include "updating/diagnosis/next_measurement.hpp"
#include "updating/diagnosis/set_up_mistakes.hpp"
#include "updating/diagnosis/stepwise_selection.hpp"
#include "updating/diagnosis/worth.hpp"
#include "updating/fit/active_constraints.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/localisation/run_drift.hpp"
#include "updating/residual/independent_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace tapfit::updating {
namespace {

// The strongest look-alike of another kind, or of the same kind elsewhere.
const EffectRef& rival_of(const Rung& rung) {
  const auto other = std::find_if(
      rung.alike.begin(), rung.alike.end(), [&rung](const EffectRef& ref) {
        return ref.effect != leading_kind(rung);
      });
  return other == rung.alike.end() ? rung.alike.front() : *other;
}

// What would tell each rung from its strongest look-alike, everything else
// being in the model. Two mistakes of the set-up foretell the same of a point
// measured anew: the sheet, not another point, is to be looked at.
std::vector<NextMeasurement> next_measurements(const Fit& fit,
                                               const std::vector<Rung>& ladder,
                                               const Fitter& fitter,
                                               const Progress& progress) {
  std::vector<NextMeasurement> result;
  for (const Rung& rung : ladder) {
    if (rung.alike.empty()) continue;
    std::vector<EffectInstance> effects = fit.effects;
    const auto own = std::find_if(
        effects.begin(), effects.end(), [&rung](const EffectInstance& e) {
          return e.effect->name() == leading_kind(rung) &&
                 e.where == rung.where;
        });
    if (own == effects.end()) continue;
    std::rotate(own, own + 1, effects.end());
    const auto fit_last = [&](const EffectInstance& last) {
      effects.back() = last;
      return fitter.fit(effects, fitter.model_for(effects), progress);
    };
    const EffectRef& rival = rival_of(rung);
    if (effects.back().effect->is_mistake() &&
        effects::find(rival.effect).is_mistake()) {
      continue;
    }
    const Fit one = fit_last(effects.back());
    const Fit other = fit_last(placed(
        effects::find(rival.effect), rival.where, fitter.problem().context));
    if (const auto next = next_measurement(one, other, fitter)) {
      result.push_back(*next);
    }
  }
  return result;
}

// The form's share of what a fit leaves stands in the floor.
void allow_for_form(const Fit& fit, const FormShare& form, Diagnosis& result) {
  result.form_sd = form.sd;
  result.form_error = form.error;
  result.floor = std::hypot(result.floor, form.error);
  constexpr double much = 0.5;
  if (form.error < much * fit.result.error) return;
  result.warnings.push_back(fmt::format(
      "of the {:.3g} that is left {:.3g} is what a deck that is wrong in form "
      "leaves: frequencies off by {:.2g} % (standard deviation), shapes "
      "likewise",
      fit.result.error,
      form.error,
      100.0 * form.sd));
}

void warn_of_bounds(Diagnosis& result) {
  for (const Rung& rung : result.ladder) {
    for (const Estimate& e : rung.parameters) {
      if (!e.at_bound) continue;
      result.warnings.push_back(
          rung.added + " " + e.name +
          " ended at its bound: the fit would go on, and what was found beside "
          "it may only make up for that");
      break;
    }
  }
}

// For each rung of the ladder what was tried in its place.
std::vector<std::vector<MadeFit>> tried_for(
    const std::vector<Rung>& ladder, const StepwiseSelection& selection) {
  const std::vector<EffectInstance>& all = selection.current().effects;
  const std::vector<SelectedEffect>& chosen = selection.chosen();
  const std::size_t already = all.size() - chosen.size();
  std::vector<std::vector<MadeFit>> tried;
  for (const Rung& rung : ladder) {
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const EffectInstance& own = all[already + k];
      if (own.effect->name() != leading_kind(rung)) continue;
      if (own.where == rung.where) tried.push_back(chosen[k].tried);
    }
  }
  return tried;
}

// The error ladder of the FRFs that a fitter has, and the fit at its top.
struct Climbed {
  Diagnosis diagnosis;
  Fit top;
};

Climbed climbed(const Fitter& fitter,
                const std::vector<EffectInstance>& present,
                const DiagnoseOptions& options,
                const Progress& progress) {
  StepwiseSelection selection(
      fitter, present, options, part_of(progress, 0.0, 0.04));
  Diagnosis result;
  result.floor = options.floor;
  result.contour = options.contour;
  result.warnings = fitter.problem().measured.statements;
  result.error_base =
      fitter.settled(selection.current(), part_of(progress, 0.04, 0.05))
          .result.error;
  result.error_fitted = result.error_base;
  // Whether another rung follows is not known: each gets a good part of what is
  // left, the first, which looks deepest, the most of all.
  double done = 0.05;
  for (int rung = 0; rung < options.max_rungs; ++rung) {
    const double next = done + 0.75 * (0.95 - done);
    const Progress part = part_of(progress, done, next);
    const Progress named = numbered(part, "rung", rung + 1);
    if (!selection.step(rung == 0, named) && !selection.settle()) break;
    done = next;
  }
  selection.settle();
  const Fit found =
      fitter.settled(selection.current(), part_of(progress, done, 0.95));
  result.error_best = found.result.error;
  const double data = independent_data(fitter.target(), found.result.residual);
  const FormShare form =
      form_share(found, fitter.target(), options.floor_noise);
  allow_for_form(found, form, result);
  const Progress last = part_of(progress, 0.95, 1.0);
  last("error ladder", 0.0);
  const Fit likeliest =
      likeliest_fit(found, fitter, {data, options.floor_noise});
  result.ladder = selection.ladder(likeliest, last);
  result.rivals = {as_made(found),
                   tried_for(result.ladder, selection),
                   selection.passed_over()};
  result.candidates = selection.candidates();
  std::ranges::stable_sort(
      result.candidates, std::greater{}, &Candidate::probability);
  result.next = next_measurements(found, result.ladder, fitter, last);
  lead_with_ladder(result.candidates,
                   result.ladder,
                   result.error_best,
                   selection.held_out_error());
  result.model_parameters = property_estimates(likeliest, options.properties);
  result.model_form = model_form(likeliest, *fitter.problem().context.deck);
  warn_of_bounds(result);
  for (const SelectedEffect& it : selection.chosen()) {
    if (it.extent) result.warnings.push_back(statement(*it.extent));
  }
  const auto fitted =
      all_estimates(found, options.properties, fitter.problem().context);
  classify_diagnosis(fitter.problem().measured.level,
                     active_constraints(options.properties, fitted),
                     result);
  if (result.verdict == "none" &&
      may_hide_effect(result.error_best,
                      floor_of(found, fitter.target(), options))) {
    result.warnings.push_back(fmt::format(
        "{:.3g} is left, far above the noise ({:.3g}) and below what mesh and "
        "form may explain (the floor is {:.3g}): an effect may hide there, and "
        "the values of the model's own parameters make up for it; a finer mesh "
        "would tell more",
        result.error_best,
        options.floor_noise,
        result.floor));
  }
  return {std::move(result), found};
}

}  // namespace

Diagnosis diagnose(const Fitter& fitter,
                   const std::vector<EffectInstance>& present,
                   const DiagnoseOptions& options,
                   const Progress& progress) {
  const Progress whole = monotonic(progress);
  Climbed ladder = climbed(fitter, present, options, whole);
  Diagnosis result = std::move(ladder.diagnosis);
  if (const auto drift = run_drift(ladder.top, fitter.target());
      drift && is_significant(*drift)) {
    result.warnings.push_back(statement(*drift));
    if (result.verdict == "none") result.verdict = "unexplained";
  }
  result.set_up =
      set_up_mistakes(result.ladder, *fitter.problem().context.bundle);
  const auto outliers =
      run_outliers(fitter.problem().foreign,
                   fitter.problem().context.bundle->runs.size(),
                   result.error_fitted);
  result.set_up.insert(result.set_up.end(), outliers.begin(), outliers.end());
  for (const SetUpMistake& mistake : result.set_up) {
    result.warnings.push_back(describe(mistake));
  }
  whole("error ladder", 1.0);
  return result;
}

}  // namespace tapfit::updating
