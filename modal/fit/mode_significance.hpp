// What each mode of a fit earns, and how large it is in the FRFs.
#pragma once

#include "modal/fit/linear_fit.hpp"
#include "modal/fit/modal_model.hpp"
#include "modal/poles/weighted_frfs.hpp"

namespace tapfit::modal {

/// Fills significance and contribution of a fit's modes: F of the two columns
/// of mode r, with c their coefficients,
///
///   F_r = sum_f c_f' [(Phi' Phi)^-1]_rr^-1 c_f / (2 n_frfs sigma_r^2)
///
/// and sigma_r^2 the mean square that is left around the mode's frequency.
///
/// @param linear the fit's linear part
void judge_modes(const WeightedFrfs& curves,
                 const LinearFit& linear,
                 ModalFit& fit);

}  // namespace tapfit::modal
