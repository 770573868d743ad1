// The screening of supports that the model has not. To hold what moves is far
// from small: each is looked at through the modes that the model has
// (modes_held.hpp), and what else is fitted readjusts to first order. A base of
// their own, which takes an answer of the large model to every degree of
// freedom that is held, is for the few that do clearly better than none.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/localisation/projected_misfit.hpp"
#include "updating/search/screened.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// @param current its model may be asked about any grid
/// @param misfit of that fit and target
/// @param now the fit's FRFs on the target's lines
/// @return all clamps that the fit has not already, least error first
[[nodiscard]] std::vector<Screened> screen_clamps(const Fit& current,
                                                  const Fitter& fitter,
                                                  const Target& target,
                                                  const ProjectedMisfit& misfit,
                                                  const Eigen::MatrixXcd& now);

/// The two best of them, standing for all, where they leave so much less than
/// the fit does that they would earn a rung.
[[nodiscard]] std::vector<Screened> promising_clamps(
    std::vector<Screened> screened, const ProjectedMisfit& misfit);

}  // namespace tapfit::updating
