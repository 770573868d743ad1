#include "updating/fit/slip_fits.hpp"

#include "updating/properties/card_slips.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {
namespace {

// Each is a base and a fit; a deck of more cards has them generated.
constexpr std::size_t most_slips = 12;

SlipFit fit_of(const structure::Deck& deck,
               const Fitter& like,
               const Progress& progress) {
  FitSetting setting = like.setting();
  setting.setting.deck = &deck;
  // Those of corrections come last, and belong to the split mesh.
  const std::size_t own = setting.setting.bundle->uncertain.size();
  setting.uncertain_sd.resize(own);
  setting.corrections.clear();
  const BaseBuilder builder = like.builder().for_deck(deck);
  const Fitter fitter(builder, std::move(setting));
  const Fit fit = fitter.fit({}, fitter.model_for({}), {{}, progress.stop});
  return {{}, {}, fit.result.error, fit.log_likelihood};
}

}  // namespace

SlipFits fit_slips(const Fitter& fitter, const Progress& progress) {
  const structure::Deck& deck = *fitter.setting().setting.deck;
  std::vector<CardSlip> likely = card_slips(deck);
  SlipFits fits;
  if (likely.empty()) return fits;
  likely.resize(std::min(most_slips, likely.size()));
  fits.plain = fit_of(deck, fitter, progress);
  for (CardSlip& slip : likely) {
    progress("cards of the deck",
             static_cast<double>(fits.slips.size()) /
                 static_cast<double>(likely.size()));
    structure::Deck corrected = deck;
    slip.correct(corrected);
    SlipFit fit = fit_of(corrected, fitter, progress);
    fit.edit = std::move(slip.edit);
    fit.elements = std::move(slip.elements);
    fits.slips.push_back(std::move(fit));
  }
  return fits;
}

}  // namespace tapfit::updating
