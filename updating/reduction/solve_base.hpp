// The dear part of a reduced base: eigenmodes of the whole model and its static
// answers at the points, as many orders of them as FRFs need.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/reduction/assembled_base.hpp"
#include "updating/reduction/base_cache.hpp"
#include "updating/structure/deck/deck.hpp"

namespace tapfit::updating {

/// @param deck as written, to name what is wrong with it
/// @throws InputError for a mechanism, or where no mode is in reach
[[nodiscard]] SolvedBase solve_base(const AssembledBase& model,
                                    const structure::Deck& deck,
                                    const Progress& progress);

}  // namespace tapfit::updating
