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
};

}  // namespace tapfit::structure
