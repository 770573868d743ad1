// The explanations worth a full fit: the best of each kind that the screening
// found, their neighbours, and every place of the kinds with few places.
#pragma once

#include "updating/diagnosis/hypothesis.hpp"
#include "updating/diagnosis/worth_fitting.hpp"
#include "updating/fit/fitter.hpp"

#include <vector>

namespace tapfit::updating {

/// @return fitted hypotheses, kind after kind; their evidence is not set
[[nodiscard]] std::vector<Hypothesis> fit_hypotheses(
    const Fit& current,
    const Fitter& fitter,
    const HypothesisOptions& options,
    const Progress& progress);

}  // namespace tapfit::updating
