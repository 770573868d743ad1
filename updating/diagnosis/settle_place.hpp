// Where between grids an effect at a point sits. Around the grid where a kind
// is likeliest its places are tried half and a quarter of the way to the next
// that were looked at (not all grids of a fine mesh are), then about a standard
// deviation around the top that these foretell. To second order the likelihood
// there is
//
//   ln p(z) = c + g' z + z' H z / 2,   z the place, in grid spacings
//
// with its top at -H^-1 g and the place's covariance -H^-1, which widens what
// is said of the effect's size. It stays on its grid unless two coordinates
// more are worth it.
#pragma once

#include "updating/diagnosis/likeliest_fit.hpp"
#include "updating/search/hypotheses.hpp"

namespace tapfit::updating {

/// @param best its effect is at a grid
/// @return the same where it is likeliest: between grids, or as it was
[[nodiscard]] Hypothesis settle_place(const Hypothesis& best,
                                      const Fit& current,
                                      const Fitter& fitter,
                                      const Judgement& judgement,
                                      const Progress& progress);

}  // namespace tapfit::updating
