// The room updating/practice. Practice cases and the judgement of their
// diagnosis.
// In:  A seed.
// Out: A virtual test's specification; whether a diagnosis found what it hides.
// May include: its row in CONTRIBUTING.md.
//
// Draws practice cases: a structure, what is hidden in it and how large, all
// from one seed. Sizes are scaled by the structure, so that what is hidden is
// felt but not gross.
#pragma once

#include "updating/virtual_test/virtual_bundle.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tapfit::updating {

/// What a case may hide: the catalogue's effects, "none", pairs joined with
/// "+"; forms of a soft support ("uneven-", "moving-", "turning-and-moving-")
/// and "unequal-sensor-mass"; two that are no effects of the catalogue,
/// "strut", a spring between two grids, and "drift", a stiffness that changes
/// while the test goes on; and "wrong-grid", a hit point that is written down
/// elsewhere.
[[nodiscard]] const std::vector<std::string>& practice_kinds();

/// Whether the structure can hide it: the plate hangs free and has no support
/// to give.
/// @param kind one of practice_kinds(), or any pair of them joined with "+"
/// @param structure one of virtual_structures()
[[nodiscard]] bool can_hide(const std::string& structure,
                            const std::string& kind);

/// @param kind as above
/// @param structure one of virtual_structures(); empty: drawn
[[nodiscard]] VirtualBundleSpec draw_practice_case(
    const std::string& kind,
    std::uint64_t seed,
    const std::string& structure = {});

}  // namespace tapfit::updating
