// The rungs of what a diagnosis found: the error after each, and the candidates
// in their order.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/diagnosis/forward_selection.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/fit/rung.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::updating {

/// Error after each rung, in the order of the largest drop: refits with ever
/// more of the effects.
///
/// @param fit with everything found
/// @param all what was chosen, in the order of the fit's effects
/// @param already effects of the fit that were in the model before
/// @throws Stopped where the progress says so
[[nodiscard]] std::vector<Rung> ladder_of(
    Fit fit,
    const std::vector<SelectedEffect>& all,
    std::size_t already,
    const Fitter& fitter,
    const Progress& progress);

/// Candidates that made it into the model are reported as fitted with all
/// others, first and in the ladder's order.
///
/// @param error with the whole ladder; on data left out, too
void lead_with_ladder(std::vector<Candidate>& candidates,
                      const std::vector<Rung>& ladder,
                      double error,
                      double held_out_error);

}  // namespace tapfit::updating
