#include "updating/diagnosis/card_swap.hpp"

#include "updating/diagnosis/worth.hpp"
#include "updating/fit/slip_fits.hpp"
#include "updating/search/screened.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

std::optional<SetUpMistake> card_swap(const Fitter& fitter,
                                      const Diagnosis& found,
                                      const DiagnoseOptions& options,
                                      const Progress& progress) {
  double least = found.error_fitted;
  for (const Candidate& effect : found.candidates) {
    least = std::min(least, effect.error);
  }
  if (least <= clear_of_floor * options.floor) return std::nullopt;
  const SlipFits fits = fit_slips(fitter, progress);
  const auto best = std::ranges::min_element(fits.slips, {}, &SlipFit::error);
  if (best == fits.slips.end()) return std::nullopt;
  // Each that was tried could have been found.
  const double gain = best->log_likelihood - fits.plain.log_likelihood -
                      std::log(static_cast<double>(fits.slips.size()));
  const bool less = best->error < worth_it * std::min(least, fits.plain.error);
  if (!less || gain < very_strong) return std::nullopt;
  Where where;
  where.elements = best->elements;
  return SetUpMistake{"card-swap",
                      std::move(where),
                      1.0 / (1.0 + std::exp(-gain)),
                      best->error,
                      best->edit};
}

}  // namespace tapfit::updating
