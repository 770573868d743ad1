// From a fit to what is kept of it, and back to where another can go on.
#pragma once

#include "updating/diagnosis/rivals.hpp"
#include "updating/fit/fitter.hpp"

namespace tapfit::updating {

[[nodiscard]] MadeFit as_made(const Fit& fit);

/// Where it ended: all that Fitter::fit_beside() goes on from.
[[nodiscard]] Fit where_it_ended(const MadeFit& made,
                                 const effects::TestContext& context);

}  // namespace tapfit::updating
