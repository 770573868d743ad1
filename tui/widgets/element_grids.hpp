// The grids that elements of a deck hang on.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::tui {

/// Each once, by their ids; corners only. Ids that are no element's are passed
/// over.
[[nodiscard]] std::vector<int> element_grids(const structure::Deck& deck,
                                             const std::vector<int>& elements);

}  // namespace tapfit::tui
