// The clamped edge of a mesh: which grids it holds, which rotation a clamp
// that gives way lets go, and the length of edge that each grid stands for.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>
#include <vector>

namespace tapfit::updating {

struct SupportEdge {
  std::vector<int> turns;           ///< 4..6: about the edge, of feet all
  std::map<int, double> length_of;  ///< grid id -> [m], 1 of a foot
  std::map<int, double> at;         ///< grid id -> 0 to 1 along the edge
};

/// @throws InputError when the grids held along basic axes form no line along a
/// basic axis
[[nodiscard]] SupportEdge support_edge(const structure::Deck& deck);

}  // namespace tapfit::updating
