// Points of a universal file that count as the model's grids by their numbers:
// whether the file's own coordinates say the same.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/structure/deck/deck.hpp"

#include <set>

namespace tapfit::updating {

/// Warns of points that lie elsewhere, as those of a mesh with numbers of its
/// own do, and of coordinates in another unit. Other axes say nothing against
/// it.
///
/// @param used numbers of the grids that something is hit or measured at
/// @param deck in SI units; gains a warning
void check_named_grids(const acquisition::TestBundle& bundle,
                       const std::set<int>& used,
                       structure::Deck& deck);

}  // namespace tapfit::updating
