// The L-curve of a fit whose regularisation is its prior.
//
// At its end the fit solves, with x = (theta - mean) / sd of all that has a
// prior and everything else adapting,
//
//   min ||S x - d||^2 + lambda^2 ||x||^2,   S = Q J diag(sd),   d = S x - Q r
//
// Q takes off what the columns of J without a prior can hold. How far the
// corner lies from the prior's own lambda says whether the priors hold more
// than the noise asks for.
#pragma once

#include "updating/fit/updater.hpp"
#include "updating/residual/l_curve.hpp"

#include <optional>

namespace tapfit::updating {

/// @return empty where nothing has a prior
[[nodiscard]] std::optional<LCurve> prior_l_curve(const UpdateResult& result);

}  // namespace tapfit::updating
