// The finite element model that a test bundle names, in SI units and checked
// against the grids that the test speaks of: of its runs, or of its ready FRFs.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/structure/deck/deck.hpp"

namespace tapfit::updating {

/// @throws InputError where the bundle names no deck, for a deck that cannot
///   be read, for a run or a ready FRF at a grid that the deck does not have
[[nodiscard]] structure::Deck read_test_model(
    const acquisition::TestBundle& bundle);

}  // namespace tapfit::updating
