// The model of a deck with numbers of its cards put right, which takes the
// place of the deck's own where effects ask for that.
#pragma once

#include "updating/effects/effect_instance.hpp"
#include "updating/fit/fit_context.hpp"

#include <memory>
#include <vector>

namespace tapfit::updating {

struct CorrectedModel {
  std::vector<EffectInstance> corrections;
  std::unique_ptr<const structure::Deck> deck;
  SolvedModel model;
  FitContext ground;  ///< points to the two
};

/// Those that put numbers of the deck right (Effect::correct_deck()).
[[nodiscard]] std::vector<EffectInstance> deck_corrections(
    const std::vector<EffectInstance>& effects);

/// @param corrections of the deck that the test has
/// @throws InputError for a deck that then has no modes; Stopped
[[nodiscard]] std::unique_ptr<CorrectedModel> correct_model(
    const MeasuredTest& test,
    std::vector<EffectInstance> corrections,
    const Progress& progress);

}  // namespace tapfit::updating
