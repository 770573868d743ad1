#include "updating/search/slip_fits.hpp"

#include <memory>
#include <utility>

namespace tapfit::updating {
namespace {

// Of a deck in the place of the fitter's own.
FitProblem problem_of(const structure::Deck& deck, const Fitter& like) {
  FitProblem problem = like.problem();
  problem.context.deck = &deck;
  // Those of corrections come last, and belong to the split mesh.
  const std::size_t own = problem.context.bundle->uncertain.size();
  problem.uncertain_sd.resize(own);
  problem.corrections.clear();
  return problem;
}

SlipFit screened(const Fitter& fitter,
                 std::shared_ptr<const FrfModel> model,
                 const Progress& progress) {
  const Fit fit =
      fitter.approach({}, std::move(model), {{}, progress.stop}).value();
  const Target& wide = fitter.problem().targets.front();
  const double error = relative_error(
      wide, fit.model->respond(fit.result.state, wide.s, false).H);
  return {{}, {}, {}, error, fit.log_likelihood};
}

SlipFit fit_through_base(const structure::Deck& deck,
                         const Fitter& like,
                         const Progress& progress) {
  const Fitter fitter(like.builder(), problem_of(deck, like));
  const FitProblem& problem = fitter.problem();
  auto model = std::make_shared<FrfModel>(like.builder().through_base(deck),
                                          problem.context,
                                          problem.measured,
                                          problem.modes);
  model->set_reference(fitter.first_state(*model, {}));
  return screened(fitter, std::move(model), progress);
}

SlipFit fit_of(const structure::Deck& deck,
               const Fitter& like,
               const Progress& progress) {
  const BaseBuilder builder = like.builder().for_deck(deck);
  const Fitter fitter(builder, problem_of(deck, like));
  const Fit fit = fitter.fit({}, fitter.model_for({}), {{}, progress.stop});
  return {{}, {}, {}, fit.result.error, fit.log_likelihood};
}

// Each slip put right.
template <typename FitOne>
std::vector<SlipFit> fit_each(const Fitter& fitter,
                              const std::vector<CardSlip>& slips,
                              const Progress& progress,
                              const FitOne& fit_one) {
  std::vector<SlipFit> fits;
  for (const CardSlip& slip : slips) {
    progress(
        "cards of the deck",
        static_cast<double>(fits.size()) / static_cast<double>(slips.size()));
    structure::Deck corrected = *fitter.problem().context.deck;
    put_right(corrected, slip);
    SlipFit fit = fit_one(corrected, fitter, progress);
    fit.edit = slip.edit;
    fit.elements = slip.elements;
    fit.kind = slip.kind;
    fits.push_back(std::move(fit));
  }
  return fits;
}

}  // namespace

SlipFits screen_slips(const Fitter& fitter,
                      const std::vector<CardSlip>& slips,
                      const Progress& progress) {
  return {screened(fitter, fitter.model_for({}), progress),
          fit_each(fitter, slips, progress, fit_through_base)};
}

SlipFits fit_slips(const Fitter& fitter,
                   const std::vector<CardSlip>& slips,
                   const Progress& progress) {
  if (slips.empty()) return {};
  return {fit_of(*fitter.problem().context.deck, fitter, progress),
          fit_each(fitter, slips, progress, fit_of)};
}

}  // namespace tapfit::updating
