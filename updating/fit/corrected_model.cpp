#include "updating/fit/corrected_model.hpp"

#include "updating/effects/effect.hpp"

#include <utility>

namespace tapfit::updating {

std::vector<EffectInstance> deck_corrections(
    const std::vector<EffectInstance>& effects) {
  std::vector<EffectInstance> corrections;
  for (const EffectInstance& e : effects) {
    if (e.effect->corrects_deck()) corrections.push_back(e);
  }
  return corrections;
}

std::unique_ptr<CorrectedModel> correct_model(
    const MeasuredTest& test,
    std::vector<EffectInstance> corrections,
    const Progress& progress) {
  auto deck = std::make_unique<structure::Deck>(*test.context.deck);
  for (const EffectInstance& one : corrections) {
    one.effect->correct_deck(one.where, *deck);
  }
  SolvedModel model =
      solve_model(*deck, *test.context.bundle, test.context.high_hz, progress);
  std::unique_ptr<CorrectedModel> result(new CorrectedModel{
      std::move(corrections), std::move(deck), std::move(model), {}});
  effects::TestContext context = test.context;
  context.deck = result->deck.get();
  context.mass_kg = result->model.builder.mass_kg();
  result->ground =
      prepare_fits(result->model,
                   {context, test.measurement, test.frfs, test.modes},
                   progress);
  return result;
}

}  // namespace tapfit::updating
