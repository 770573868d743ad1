// The clamped edge of a mesh: which grids it holds, which rotation a clamp
// that gives way lets go, and the length of edge that each grid stands for.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>

namespace tapfit::updating {

struct SupportEdge {
  int component = 4;                ///< 4..6, rotation about the edge
  std::map<int, double> length_of;  ///< grid id -> [m]
  std::map<int, double> at;         ///< grid id -> 0 to 1 along the edge
};

/// @throws InputError when the grids held along basic axes form no line along a
/// basic axis
[[nodiscard]] SupportEdge support_edge(const structure::Deck& deck);

}  // namespace tapfit::updating
