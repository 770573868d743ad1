// Shells of a shape that is more likely a slip in a grid than meant.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// One sentence for quadrilaterals with a corner further from their mean plane
/// than 5 % of their mean diagonal (they are taken as flat, with stiff arms to
/// the corners), one for shells with an edge 100 times shorter than another of
/// theirs; each names its cards.
[[nodiscard]] std::vector<std::string> element_shape_warnings(const Deck& deck);

}  // namespace tapfit::structure
