// Patches of elements, longer or shorter by a layer.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// A patch with one layer more, and with one less, on each of its six sides.
/// Sides are those of the box around its elements' middles, along the axes of
/// its first element (a shell's first edge and normal, a bar's own); a layer is
/// what lies within half of the outermost of element_cells(). So many steps
/// lead from a box to any other.
///
/// @param patch ids, not empty
/// @return ids ascending; no patch larger than half of all elements
[[nodiscard]] std::vector<std::vector<int>> stretched_patches(
    const std::vector<int>& patch, const structure::Deck& deck);

/// Without its outermost layer on every side that it may be longer on; the
/// patch itself where nothing would be left.
[[nodiscard]] std::vector<int> inner_patch(std::vector<int> patch,
                                           const structure::Deck& deck);

/// The layers themselves that a patch may be longer by, in the order of the
/// sides; sides beyond which there is nothing have none.
[[nodiscard]] std::vector<std::vector<int>> layers_beside(
    const std::vector<int>& patch, const structure::Deck& deck);

}  // namespace tapfit::updating
