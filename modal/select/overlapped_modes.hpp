// Modes among heavily damped ones, where each resonance reaches over its
// neighbours: noise keeps their poles from lasting over the orders, and what
// the fit leaves has no peak. One between two poles is tried everywhere.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/fit/modal_fit.hpp"
#include "modal/poles/identify_options.hpp"

namespace tapfit::modal {

/// Adds poles between those of a fit where resonances overlap, as long as none
/// is less needed with them than noise could be.
///
/// @return the fit as it was where none is missing
[[nodiscard]] ModalFit add_overlapped(const WeightedFrfs& curves,
                                      ModalFit fit,
                                      const IdentifyOptions& options,
                                      const Progress& progress);

}  // namespace tapfit::modal
