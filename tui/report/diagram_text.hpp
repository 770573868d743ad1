// The stabilisation diagram as text, for reports and scripts.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <string>

namespace tapfit::tui {

/// Rows are model orders, columns frequencies; each cell shows the steadiest
/// pole in it by its letter (s, d, v, f, o). Below stand the modes taken (^),
/// the summed FRF and the singular values of the FRF matrix (CMIF) as bars over
/// 60 dB.
///
/// @param frfs the set that the modes were identified from
/// @param low_hz, high_hz what is shown [Hz]
[[nodiscard]] std::string diagram_text(const modal::ModeSet& modes,
                                       const signal::FrfSet& frfs,
                                       double low_hz,
                                       double high_hz);

}  // namespace tapfit::tui
