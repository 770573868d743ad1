// From FRFs to modes: poly-reference LSCF, stabilisation, residues.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "modal/select/pole_edit.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tapfit::modal {

struct IdentifyOptions {
  int max_order = 100;  ///< pairs of poles; cut to what the lines carry
  double frequency_tolerance = 0.01;  ///< relative, between orders
  double damping_tolerance = 0.05;    ///< relative
  double vector_tolerance = 0.02;     ///< 1 - MAC of participation vectors

  // Hard checks: a pole that fails one is no mode.
  double least_damping_ratio = 1e-6;
  double max_damping_ratio = 0.2;
  double least_mpc = 0.2;       ///< from three FRFs on
  double largest_mpd_deg = 60;  ///< from three FRFs on

  std::optional<std::array<double, 2>> band_hz;  ///< of the lines; else all
  std::vector<PoleEdit> edits;                   ///< by hand, in this order

  bool operator==(const IdentifyOptions&) const = default;
};

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
