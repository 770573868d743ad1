// The room updating/localisation. Where something is missing and what it is
// like, to first order or at one place, without a fit.
// In:  A fit.
// Out: Misfit per place, the missing dynamic stiffness, points that were not
//      where they were written down.
// May include: its row in CONTRIBUTING.md.
//
// The missing dynamic stiffness at one place, line by line.
//
//   H_model,oi - H_measured,oi = w H_ob H_bi,   z = w / (1 - H_bb w)
//
// w is solved on each line by least squares over all FRFs; how well one w fits
// them says where, how z runs over frequency says what: s^2 a mass, 1 a
// spring, s a dashpot, a resonance an absorber.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/localisation/signature.hpp"

namespace tapfit::updating {

/// @param node a grid of the deck
[[nodiscard]] Signature signature_at(Fit current,
                                     const Fitter& fitter,
                                     int node,
                                     const Progress& progress = {});

}  // namespace tapfit::updating
