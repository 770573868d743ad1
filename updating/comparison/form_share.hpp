// What of a fit's error the deck's form may explain: its share of the floor.
#pragma once

#include "updating/fit/fitter.hpp"

namespace tapfit::updating {

/// What of a fit's error the deck's form explains.
struct FormShare {
  double sd = 0.0;     ///< of a mode's frequency, relative
  double error = 0.0;  ///< what it explains, of a form that is off by more than
                       ///< 0.9 % in frequency the part of one that is by that
  double left = 0.0;  ///< what no form explains: all, where it would have to be
                      ///< off by more than any careful deck is, 2 %
  double usual = 0.0;  ///< of what it explains, what a careful deck leaves in
                       ///< the middle: off by 0.3 % in frequency
};
/// It is judged by the independent data in what this fit leaves: a fit that is
/// compared with others may be weighed by another count.
/// @param target that the fit's residual is of
/// @param noise relative error that the scatter over hits alone would give
/// @return nothing explained for what is no fit, as the deck as it is
[[nodiscard]] FormShare form_share(const Fit& fit,
                                   const Target& target,
                                   double noise);

}  // namespace tapfit::updating
