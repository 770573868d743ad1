// The modes that FRFs show when nothing else is asked for.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <array>
#include <optional>

namespace tapfit::updating {

/// @param band_hz of the lines; else all
/// @return none where modes cannot be told, from a few lines say: FRFs there
///   are
[[nodiscard]] std::optional<modal::ModeSet> default_identification(
    const signal::FrfSet& frfs,
    const std::optional<std::array<double, 2>>& band_hz,
    const Progress& progress);

}  // namespace tapfit::updating
