// Shells at their edges: lines along these, and the faces there.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tapfit::updating {

/// Unit vector across the mid-surface.
[[nodiscard]] Eigen::Vector3d normal_of(const structure::Deck& deck,
                                        const structure::Shell& shell);

/// The shell's own, else its property's [m].
[[nodiscard]] double thickness_of(const structure::Deck& deck,
                                  const structure::Shell& shell);

using Edge = std::array<int, 2>;  ///< grid ids, ascending

[[nodiscard]] Edge edge_of(int a, int b);

/// Edges of the shells and the shells (by position) that have them.
using Edges = std::map<Edge, std::vector<std::size_t>>;

[[nodiscard]] Edges edges_of(const structure::Deck& deck);

/// Line through grids, as a point and a direction.
struct Ray {
  Eigen::Vector3d from;
  Eigen::Vector3d along;
  double length = 0.0;
};

[[nodiscard]] Ray ray_of(const structure::Deck& deck,
                         const std::vector<int>& nodes);

[[nodiscard]] bool on_ray(const Ray& ray, const Eigen::Vector3d& x);

/// Edges with a grid on the line.
[[nodiscard]] Edges edges_at(const structure::Deck& deck, const Ray& ray);

/// Neighbours along edges between two shells, and grids on a free edge.
struct Net {
  std::map<int, std::vector<int>> inner;
  std::set<int> rim;
};

[[nodiscard]] Net net_of(const Edges& edges);

/// The grid to which an edge between two shells leads straight on from another;
/// 0 where the mesh does not.
/// @param along unit vector
[[nodiscard]] int straight_on(const structure::Deck& deck,
                              const Net& net,
                              int from,
                              const Eigen::Vector3d& along);

/// Edges between two shells on the line through the grids.
/// @param edges with a grid on it, or more
[[nodiscard]] std::set<Edge> edges_on(const structure::Deck& deck,
                                      const Edges& edges,
                                      const Ray& ray);

/// Shells on one side of a line: those reached from one another without
/// crossing it, one component of the two for every piece of the line.
///
/// @param edges with a grid on it, or more
/// @param nodes of the line, around which one shell leads to the next
/// @return ids
[[nodiscard]] std::vector<int> one_side(const structure::Deck& deck,
                                        const Edges& edges,
                                        const std::set<Edge>& line,
                                        const std::set<int>& nodes);

}  // namespace tapfit::updating
