// The screening of mistakes of the set-up: points of the sheet at every other
// grid, and faults of the measurement that have no parameters, as they are.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/localisation/projected_misfit.hpp"
#include "updating/search/screened.hpp"

#include <vector>

namespace tapfit::updating {

/// Whether screen_mistakes() looks at an effect.
[[nodiscard]] bool is_screened_mistake(const effects::Effect& effect,
                                       const effects::TestContext& context);

/// Those in some runs only are left out where their FRFs have too little of the
/// misfit to be worth a rung.
///
/// @param current its model may be asked about any grid
/// @param misfit of that fit and target
/// @param measured the target's FRFs
/// @return in no order
[[nodiscard]] std::vector<Screened> screen_mistakes(
    const Fit& current,
    const Target& target,
    const ProjectedMisfit& misfit,
    const signal::FrfSet& measured);

}  // namespace tapfit::updating
