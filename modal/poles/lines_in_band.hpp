// FRFs on part of their lines, for identification band by band.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <array>

namespace tapfit::modal {

/// The set on its lines from band_hz[0] to band_hz[1], both included.
///
/// @throws InputError when fewer than 8 lines lie in the band
[[nodiscard]] signal::FrfSet lines_in_band(
    const signal::FrfSet& frfs, const std::array<double, 2>& band_hz);

}  // namespace tapfit::modal
