// A deck whose elements were split.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>
#include <vector>

namespace tapfit::structure {

struct RefinedDeck {
  Deck deck;  ///< the original grids keep their ids; new ones come after
  /// Original element id -> ids of its children (itself where not split).
  std::map<int, std::vector<int>> children;
  /// New grid id -> the two or four original grids it lies between.
  std::map<int, std::vector<int>> between;

  /// Ids of what elements of the original deck were split into.
  [[nodiscard]] std::vector<int> pieces_of(
      const std::vector<int>& elements) const {
    if (children.empty()) return elements;
    std::vector<int> result;
    for (const int id : elements) {
      const auto it = children.find(id);
      if (it == children.end()) continue;
      result.insert(result.end(), it->second.begin(), it->second.end());
    }
    return result;
  }
};

}  // namespace tapfit::structure
