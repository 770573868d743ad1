// Degrees of freedom that a base must hold exactly: where something is hit,
// measured or acted on.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/effects/effect.hpp"
#include "updating/frf_model/model_state.hpp"
#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// @return degrees of freedom (6 grid_index + component - 1) that low-rank
///   effects act on, and those that were hit or measured where the sheet has
///   others, for residual vectors
[[nodiscard]] std::vector<int> acted_points(
    const effects::TestContext& context,
    const std::vector<EffectInstance>& effects);

/// Degrees of freedom that are hit or measured, ascending.
struct MeasuredPoints {
  std::vector<int> all;
  /// One end of every pair: those that are hit or those that are measured,
  /// whichever are fewer.
  std::vector<int> driven;
};
[[nodiscard]] MeasuredPoints measured_points(
    const structure::Deck& deck, const acquisition::TestBundle& bundle);

}  // namespace tapfit::updating
