// Whether an FRF's coherence was measured at all.
#pragma once

#include "signal/frf_set/frf_set.hpp"

namespace tapfit::signal {

/// A single hit's coherence is 1 whatever it is worth, and so is that of ready
/// FRFs whose file has none: these say nothing.
[[nodiscard]] bool has_coherence(const Frf& frf);

}  // namespace tapfit::signal
