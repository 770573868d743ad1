// A cheap look at every effect at every place: how much of the present misfit
// would go if it sat there, uncertain properties and damping readjusting.
//
// One degree of freedom b with dynamic stiffness z changes every FRF by
//   delta H_oi = -H_ob w H_bi,   w = z / (1 + H_bb z)      (eq. 15, rank one)
// which is scanned over sizes of z. A joint or a loss of stiffness changes the
// FRFs in proportion to its compliance, to first order, and its size is found
// by least squares. The readjustment is linear: the misfit is projected off the
// tangent space of the other parameters.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/search/screened.hpp"

#include <vector>

namespace tapfit::updating {

/// Screens the effects of the catalogue that may sit at many places.
///
/// @return all hypotheses, least remaining error first
[[nodiscard]] std::vector<Screened> screen(const Fit& current,
                                           const Fitter& fitter,
                                           const Progress& progress);

/// Screens the last effect of a fit at all its grids, with what is fitted
/// besides as it stands there: far closer than before anything was fitted, and
/// what acts on one mode alone does as well wherever that moves as much.
///
/// @param current without the effect
/// @param best    with it, at a grid
/// @return the effect at its most promising grids, least remaining error first
[[nodiscard]] std::vector<Screened> screen_elsewhere(const Fit& current,
                                                     const Fit& best,
                                                     const Fitter& fitter,
                                                     const Progress& progress);

}  // namespace tapfit::updating
