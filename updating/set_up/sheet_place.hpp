// Places of mistakes of the sheet as a user writes them: "acc1:8:6:run4-6" for
// acc1 at grid 8 on the sheet and at grid 6 on the structure in runs 4 to 6,
// "acc1:8:" where the latter is yet to be said, "acc1:8:+X" for acc1 at grid 8
// along X. Points of the test's own are "P3".
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::effects {

/// Reads channels, grids, a variant, then runs. What is not there is left open.
/// Of two grids the first is the sheet's; one alone is the structure's where
/// the effect takes any grid and no ":" follows, or else the sheet's.
///
/// @param parts what stands between the colons
[[nodiscard]] Location read_sheet_place(std::vector<std::string> parts,
                                        const Effect& effect);

/// The same the other way round; read_sheet_place() has it back.
[[nodiscard]] std::string sheet_place_text(const Location& where);

}  // namespace tapfit::effects
