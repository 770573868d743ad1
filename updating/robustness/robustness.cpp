#include "updating/robustness/robustness.hpp"

#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/likeliest_fit.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/residual/independent_data.hpp"
#include "updating/robustness/refit_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace tapfit::updating {
namespace {

// Fewer runs have another share of noise.
DiagnoseOptions options_for(DiagnoseOptions options,
                            const SettingChange& change,
                            const Fitter& fitter) {
  if (change.left_out.empty()) return options;
  const double mesh = std::sqrt(std::max(
      0.0, std::pow(options.floor, 2) - std::pow(options.floor_noise, 2)));
  options.floor_noise = noise_error(fitter.target());
  options.floor = std::hypot(mesh, options.floor_noise);
  return options;
}

// Of all that was found, as the diagnosis tells them.
Fit told(const Fit& found,
         const Fitter& fitter,
         const DiagnoseOptions& options) {
  const double data = independent_data(fitter.target(), found.result.residual);
  return likeliest_fit(found, fitter, {data, options.floor_noise});
}

// The rung's effect in the fit; nothing where it is not there.
std::optional<std::size_t> position_of(const Rung& rung, const Fit& fit) {
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    const EffectInstance& e = fit.effects[k];
    if (e.effect->name() == leading_kind(rung) && e.where == rung.where) {
      return k;
    }
  }
  return std::nullopt;
}

void take_sizes(const std::vector<Rung>& ladder,
                const Fit& fit,
                const effects::TestContext& context,
                Robustness& row) {
  for (const Rung& rung : ladder) {
    const auto at = position_of(rung, fit);
    if (!at) continue;
    for (Estimate e : effect_estimates(fit, *at, context)) {
      const auto was =
          std::ranges::find(rung.parameters, e.name, &Estimate::name);
      if (was != rung.parameters.end() && was->sd > 0.0) {
        row.largest_move_sd = std::max(
            row.largest_move_sd, std::abs(e.value - was->value) / was->sd);
      }
      e.name = label_of(fit.effects, *at) + " " + e.name;
      row.parameters.push_back(std::move(e));
    }
  }
}

}  // namespace

FirmnessCheck::FirmnessCheck(const Fitter& fitter,
                             const DiagnoseOptions& options,
                             const Diagnosis& diagnosis,
                             const Progress& progress)
    : fitter_(&fitter),
      options_(options),
      diagnosis_(&diagnosis),
      unchanged_(refits_of(diagnosis.rivals, fitter, progress)) {}

Robustness FirmnessCheck::under(const SettingChange& change,
                                const Progress& progress) const {
  const Fitter fitter = fitter_->with(changed(fitter_->problem(), change));
  const DiagnoseOptions options = options_for(options_, change, fitter);
  const Refits refits = refits_under(change, unchanged_, fitter, progress);
  Robustness row;
  row.change = change.what;
  row.verdict =
      verdict_of(refits, fitter, options, *diagnosis_, {{}, progress.stop});
  row.verdict_stands = row.verdict == diagnosis_->verdict;
  take_sizes(diagnosis_->ladder,
             told(refits.found, fitter, options),
             fitter.problem().context,
             row);
  return row;
}

std::vector<Robustness> robustness(const Fitter& fitter,
                                   const DiagnoseOptions& options,
                                   const Diagnosis& diagnosis,
                                   const Progress& progress) {
  const Progress whole = monotonic(progress);
  const std::vector<SettingChange> changes =
      setting_changes(fitter.problem(), options.properties);
  const double parts = static_cast<double>(changes.size()) + 1.0;
  const FirmnessCheck check(
      fitter, options, diagnosis, part_of(whole, 0.0, 1.0 / parts));
  std::vector<Robustness> rows;
  double done = 1.0 / parts;
  for (const SettingChange& change : changes) {
    rows.push_back(
        check.under(change, part_of(whole, done, done + 1.0 / parts)));
    done += 1.0 / parts;
  }
  // So near the border that the same fits, made again, fall on its other side.
  Robustness same = check.under({"nothing, only fitted again"}, whole);
  if (!same.verdict_stands) rows.insert(rows.begin(), std::move(same));
  return rows;
}

}  // namespace tapfit::updating
