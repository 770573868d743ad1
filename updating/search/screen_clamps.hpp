// The screening of supports that the model has not. To hold what moves is far
// from small: each is worked out in a base of its own on the deck's own mesh,
// and only what else is fitted readjusts to first order.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/localisation/misfit_scan.hpp"
#include "updating/search/screened.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// @param misfit of that fit and target
/// @param now the fit's FRFs on the target's lines
/// @return in no order; places that a fit has already are left out
[[nodiscard]] std::vector<Screened> screen_clamps(const Fit& current,
                                                  const Fitter& fitter,
                                                  const Target& target,
                                                  const MisfitScan& misfit,
                                                  const Eigen::MatrixXcd& now);

}  // namespace tapfit::updating
