// Elements that count as one place.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Elements of one property that lie together: one of a coarse mesh, several of
/// a fine one.
struct ElementCell {
  std::vector<int> elements;  ///< ids, ascending
  int property = 0;
  Eigen::Vector3d middle;  ///< of its elements' middles [m]
};

/// Every shell, bar, rod and solid of the deck in one cell each, as gathered()
/// has their middles.
[[nodiscard]] std::vector<ElementCell> element_cells(
    const structure::Deck& deck);

}  // namespace tapfit::updating
