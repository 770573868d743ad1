// The room updating/search. Where something may be missing: every effect at
// all its places screened, the best of them fitted, and places around those.
// In:  Fits of one test.
// Out: Hypothesis lists. What they are worth is judged in updating/diagnosis.
// May include: its row in CONTRIBUTING.md.
//
// The explanations worth a full fit: the best of each kind that the screening
// found, their neighbours, and every place of the kinds with few places.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/search/hypothesis.hpp"
#include "updating/search/worth_fitting.hpp"

#include <vector>

namespace tapfit::updating {

/// @return fitted hypotheses, kind after kind; their evidence is not set
[[nodiscard]] std::vector<Hypothesis> fit_hypotheses(
    const Fit& current,
    const Fitter& fitter,
    const HypothesisOptions& options,
    const Progress& progress);

}  // namespace tapfit::updating
