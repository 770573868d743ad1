// Seams of a mesh whose elements are split. Elements beside a seam have grids
// of their own, doubles of the others' at the same places: what ties and
// springs these ties and springs the middles between them, or the halves would
// gape there. Springs of a support are shared with its middles alike.
#pragma once

#include "updating/structure/mesh/split_edges.hpp"

namespace tapfit::structure {

/// Ties the middles of edges between doubles as their ends are tied, and gives
/// the middles their share of the springs at both ends. All shells and bars
/// must have been split.
void tie_seams(SplitEdges& edges);

}  // namespace tapfit::structure
