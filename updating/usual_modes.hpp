// The modes that FRFs show when nothing else is asked for.
#pragma once

#include "acquisition/progress.hpp"
#include "modal/mode_set.hpp"
#include "signal/frf_set.hpp"

#include <optional>

namespace tapfit::updating {

/// @return none where modes cannot be told, from a few lines say: FRFs there
///   are
[[nodiscard]] std::optional<modal::ModeSet> usual_modes(
    const signal::FrfSet& frfs,
    const Progress& progress);

}  // namespace tapfit::updating
