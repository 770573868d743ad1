// The room modal/identify. The whole way from FRFs to modes.
// In:  FrfSet and IdentifyOptions.
// Out: ModeSet with uncertainties and warnings.
// May include: its row in CONTRIBUTING.md.
//
// From FRFs to modes: poly-reference LSCF, stabilisation, residues.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "modal/poles/identify_options.hpp"
#include "signal/frf_set/frf_set.hpp"

namespace tapfit::modal {

/// Identifies the modes in the FRFs' band, or in the one asked for.
///
/// @param frfs accelerances on s = sigma + j omega with one sigma and evenly
///   spaced lines; sigma is taken out of the poles
/// @throws InputError when there are too few lines or FRFs to identify from, or
///   no pole where one is to be dropped or added
[[nodiscard]] ModeSet identify_modes(const signal::FrfSet& frfs,
                                     const IdentifyOptions& options,
                                     const Progress& progress = {});

}  // namespace tapfit::modal
