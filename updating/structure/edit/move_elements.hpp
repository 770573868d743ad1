// Elements of a deck on other grids than their cards say.
#pragma once

#include "updating/structure/edit/weaken_cards.hpp"

#include <map>

namespace tapfit::structure {

/// Element -> grid -> the grid that it takes instead.
using GridMoves = std::map<int, std::map<int, int>>;

/// Gives the cards of these shells and bars anew, on what property `weak`
/// gives them. Both must outlive the result.
[[nodiscard]] CardEdit move_elements(const GridMoves& moves,
                                     const WeakenCards& weak);

}  // namespace tapfit::structure
