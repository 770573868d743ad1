// The room updating/prediction. What a known change will do to the structure:
// predict, then tap.
// In:  The best fit of a test, and changes with their sizes.
// Out: Prediction: modes and FRFs after the change, with intervals; and whether
//      modes measured then confirm it.
// May include: its row in CONTRIBUTING.md.
#pragma once

#include "updating/comparison/comparison.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/prediction/prediction.hpp"
#include "updating/prediction/stated_change.hpp"

#include <vector>

namespace tapfit::updating {

/// What a prediction stands on.
struct PredictionBasis {
  const Fit& fit;
  const Fitter& fitter;
  const Comparison& comparison;  ///< of that fit
  const signal::FrfSet& frfs;    ///< measured
  const modal::ModeSet& modes;   ///< measured
};

/// @param changes one at least; their sizes are not fitted
/// @throws InputError as of place_change(), check_size() and changed_model();
///   Stopped
[[nodiscard]] Prediction predict_change(
    const PredictionBasis& basis,
    const std::vector<StatedChange>& changes,
    const Progress& progress);

}  // namespace tapfit::updating
