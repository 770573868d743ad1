#include "updating/prediction/predict_change.hpp"

#include "updating/comparison/form_share.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/prediction/changed_model.hpp"
#include "updating/prediction/predicted_frfs.hpp"
#include "updating/prediction/predicted_modes.hpp"
#include "updating/residual/independent_data.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace tapfit::updating {
namespace {

// tau^2 / 4 of the deck's form as the fit tells it: of ln f of a mode.
double form_variance(const PredictionBasis& basis) {
  const Fit& fit = basis.fit;
  if (!fit.form.has_patterns()) return 0.0;
  const double data =
      independent_data(basis.fitter.target(), fit.result.residual);
  const FormEstimate form =
      estimate_form(fit.form, data, basis.comparison.floor_noise);
  return 0.25 * form.mean_tau * form.mean_tau;
}

std::vector<std::size_t> measured_runs(const FitProblem& problem) {
  std::set<std::size_t> runs;
  for (const signal::Frf& frf : problem.measured.frfs) runs.insert(frf.run);
  if (runs.empty()) runs.insert(0);
  return {runs.begin(), runs.end()};
}

std::vector<std::string> warnings_of(const Prediction& prediction,
                                     const ChangedModel& model) {
  // Beyond three deviations a mode is no longer what the fit says it is; a
  // shape that is less than half its own is another.
  constexpr double far = 3.0;
  constexpr double own_shape = 0.5;
  std::vector<std::string> warnings;
  for (const PredictedMode& mode : prediction.modes) {
    if (std::abs(mode.misfit_sd) > far) {
      warnings.push_back(fmt::format(
          "the mode measured at {:.6g} Hz is {:.6g} Hz in the model, {:.1f} "
          "standard deviations off: something is missing there, and the "
          "interval is too narrow",
          mode.measured_hz,
          mode.model_hz,
          std::abs(mode.misfit_sd)));
    }
    if (mode.mac < own_shape) {
      warnings.push_back(
          fmt::format("the mode at {:.6g} Hz changes its shape (MAC {:.2f}): "
                      "what it becomes is the likest that the change allows",
                      mode.model_hz,
                      mode.mac));
    }
  }
  for (const double hz : new_frequencies(model)) {
    warnings.push_back(
        fmt::format("the change brings a mode of its own, at {:.4g} Hz", hz));
  }
  return warnings;
}

}  // namespace

Prediction predict_change(const PredictionBasis& basis,
                          const std::vector<StatedChange>& changes,
                          const Progress& progress) {
  const FitProblem& problem = basis.fitter.problem();
  Prediction prediction;
  prediction.with = basis.fit.result.state.effects;
  for (const StatedChange& change : changes) {
    prediction.change.push_back(place_change(change, problem.context));
  }
  progress("prediction: the changed model", 0.0);
  const ChangedModel model =
      changed_model(basis.fit, basis.fitter, prediction.change);
  prediction.model = model.after;
  const double form = form_variance(basis);
  prediction.form_sd = std::sqrt(form);
  progress("prediction: modes", 0.3);
  const KnownNow known{basis.modes,
                       basis.comparison.pairs,
                       parameter_spread(basis.fit),
                       form,
                       measured_runs(problem)};
  prediction.modes = predicted_modes(model, known);
  if (!basis.fitter.target().is_modal()) {
    progress("prediction: FRFs", 0.7);
    prediction.frfs = predicted_frfs(model, basis.frfs);
    prediction.frf_changes =
        frf_changes(model, basis.fitter.target(), known.covariance, form);
  }
  prediction.warnings = warnings_of(prediction, model);
  return prediction;
}

}  // namespace tapfit::updating
