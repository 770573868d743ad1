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

/// Adds other forms of supports and sensors, which are few, that do better than
/// the plain ones: a clamp that gives in two ways may look like something else
/// in either.
/// @param found by a quick look, as judged; only what comes near the best of it
///   is taken further
void add_forms_of_few(std::vector<Hypothesis>& found,
                      const Fit& current,
                      const Fitter& fitter,
                      const Progress& progress);

}  // namespace tapfit::updating
