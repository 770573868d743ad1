// Accelerances of the loaded structure that were not measured, from its modes:
// what is needed to free FRFs of the sensors' mass where the hammer did not hit
// the sensor's own place.
//
//   A_ab(s) = s^2 sum_r [ R_r / (s - lambda_r) + conj(R_r) / (s -
//             conj(lambda_r)) ] + T_ab(s),  R_r = phi_a phi_b / (2 j omega_d,r)
//
// with the poles of the set-up asked for. T, the modes out of the band, is not
// identified at a point that was not hit: at a driving point all of them push
// the same way, so that the mean of the measured driving points is taken, with
// their rms as standard deviation; between two points it is taken as zero, with
// the rms of all FRFs.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/mass_removal/free_frfs.hpp"

namespace tapfit::modal {

/// @param modes identified from `frfs`, with their fit
/// @param frfs the set to be freed
/// @return a model that knows nothing where the shapes have no scale or lack
///   one of the points
[[nodiscard]] signal::FrfModel loaded_frf_model(const ModeSet& modes,
                                                const signal::FrfSet& frfs);

}  // namespace tapfit::modal
