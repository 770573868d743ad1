// From FRFs to modes: poly-reference LSCF, stabilisation, residues.
#pragma once

#include "acquisition/progress.hpp"
#include "modal/mode_set.hpp"
#include "signal/frf_set.hpp"

namespace tapfit::modal {

struct IdentifyOptions {
  int max_order = 100;  ///< pairs of poles; cut to what the lines carry
  double frequency_tolerance = 0.01;  ///< relative, between orders
  double damping_tolerance = 0.05;    ///< relative
  double vector_tolerance = 0.02;     ///< 1 - MAC of participation vectors
  double max_damping_ratio = 0.1;
};

/// Identifies the modes in the FRFs' band.
///
/// @param frfs accelerances on s = sigma + j omega with one sigma and evenly
///   spaced lines; sigma is taken out of the poles
/// @throws InputError when there are too few lines or FRFs to identify from
[[nodiscard]] ModeSet identify_modes(const signal::FrfSet& frfs,
                                     const IdentifyOptions& options,
                                     const Progress& progress = {});

}  // namespace tapfit::modal
