// A crack through a shell over part of a line of mesh edges: its two faces are
// parted. Where it ends inside the shell its last grid is its tip, which holds
// both; at a free edge it opens.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace tapfit::updating {

/// A grid that elements on one side part from. Their turn about the normal goes
/// with it as before: shells have next to no stiffness there.
struct PartedGrid {
  int node = 0;
  double area = 0.0;  ///< of the face that it carries [m^2]
  double turn = 0.0;  ///< its second moment about the mid-surface [m^4]
  /// Unit vectors along basic axes: along the line, across it, and normal to
  /// the shells that part. They move along all three and turn about the first
  /// two.
  std::array<Eigen::Vector3d, 3> axes;
};

struct CrackLine {
  std::vector<PartedGrid> grids;
  std::vector<int> side;  ///< ids of the elements on one side that touch them
};

/// @param deck the one that the grids are of, or the same with its mesh split
/// @param nodes from one end to the other, two or more
/// @return no grids where nothing parts, or where they are not joined by edges
///   between two shells
[[nodiscard]] CrackLine crack_line(const structure::Deck& deck,
                                   const std::vector<int>& nodes);

/// Cracks along lines of joint_places(), as long as they run along and within a
/// patch of elements.
/// @param elements ids
[[nodiscard]] std::vector<std::vector<int>> cracks_within(
    const structure::Deck& deck, const std::vector<int>& elements);

/// A crack longer or shorter by a grid at one of its ends, or of half its
/// length.
/// @param nodes from one end to the other
[[nodiscard]] std::vector<std::vector<int>> cracks_near(
    const structure::Deck& deck, const std::vector<int>& nodes);

}  // namespace tapfit::updating
