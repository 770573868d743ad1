// Where the hammer struck a second time, for those who look at a double hit.
#pragma once

#include "acquisition/hits/hits.hpp"
#include "tui/widgets/trace.hpp"

#include <cstddef>

namespace tapfit::tui {

/// The time of the largest force beside the main pulse [s, from the file's
/// start], as far from it as a pulse is no hit of its own; that of the main
/// pulse where the hit is not judged double.
/// @param hammer its channel in the trace
[[nodiscard]] double second_blow(const Trace& trace,
                                 std::size_t hammer,
                                 const acquisition::HitSet& hits,
                                 const acquisition::Hit& hit);

}  // namespace tapfit::tui
