// The lines of a mesh of quadrilaterals, so that a coarser picture of it can be
// drawn where the edges would run into each other.
//
// Edges that run straight on from one quadrilateral to the next make one line.
// A line's depth is the number of quadrilaterals between it and the mesh's
// outline; lines of every second depth are a mesh of half as many lines, of
// every fourth a quarter.
#pragma once

#include <array>
#include <map>
#include <vector>

namespace tapfit::tui {

/// Two grids, the smaller index first.
using Edge = std::array<int, 2>;

struct MeshEdge {
  int depth = 0;         ///< of its line; 0 where it belongs to none
  bool outline = false;  ///< of one face only
};

/// @param faces indices of the grids round each; those that are no
///   quadrilaterals have no lines, their edges the depth 0
/// @return every edge of a face; where a mesh has no outline, depths count from
///   one of its lines
[[nodiscard]] std::map<Edge, MeshEdge> mesh_edges(
    const std::vector<std::vector<int>>& faces);

}  // namespace tapfit::tui
