// Patches of elements that may have lost stiffness together.
#pragma once

#include "updating/structure/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// Each shell and bar alone, with all within growing distances around it, and
/// all of a property. Every set once, ids ascending.
[[nodiscard]] std::vector<std::vector<int>> element_patches(
    const structure::Deck& deck);

/// Middle of each shell and bar, by element id.
struct ElementCentre {
  int id = 0;
  int property = 0;
  Eigen::Vector3d position;
  double size = 0.0;  ///< [m] side of a shell, length of a bar
};
[[nodiscard]] std::vector<ElementCentre> element_centres(
    const structure::Deck& deck);

}  // namespace tapfit::updating
