// Fits of all that is planned, in two passes: each as far as shows how likely
// it ends, then to the end those that may be the answer.
#pragma once

#include "updating/search/hypothesis.hpp"
#include "updating/search/reach.hpp"
#include "updating/search/worth_fitting.hpp"

#include <vector>

namespace tapfit::updating {

/// Works on all cores, whatever kind a fit is of.
///
/// @param reach takes what both passes reach
/// @return for each plan its fits that arrived; the known one last
[[nodiscard]] std::vector<std::vector<Hypothesis>> fit_planned(
    std::vector<Planned> plans,
    const Fit& current,
    const Fitter& fitter,
    const HypothesisOptions& options,
    Reach& reach,
    const Progress& progress);

}  // namespace tapfit::updating
