// Where a structure could be jointed: straight lines of mesh edges across
// shells, from one free edge to another, and the ends of bars.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// A grid of a joint: elements of one side turn about `axis` there.
struct JointGrid {
  int node = 0;
  Eigen::Vector3d axis;  ///< unit vector, basic axes
  double length = 0.0;   ///< of the joint that the grid carries [m]; 1 on bars
};

struct JointLine {
  std::vector<JointGrid> grids;
  std::vector<int> side;  ///< ids of the elements on one side that touch it
  double length = 0.0;    ///< total [m]; 1 on bars
};

struct JointPlace {
  std::vector<int> nodes;  ///< along the line; one grid where bars meet
  int bar = 0;             ///< which of three or more bars turns; 0: either
};

/// Every straight line along which the deck's shells could be jointed, each by
/// itself, then lines in line with each other together, then bar ends.
[[nodiscard]] std::vector<JointPlace> joint_places(const structure::Deck& deck);

/// The joint along a line of shells, on the deck that the line is of or on the
/// same deck with its mesh split.
///
/// @param nodes as in JointPlace, two or more
[[nodiscard]] JointLine shell_joint(const structure::Deck& deck,
                                    const std::vector<int>& nodes);

/// The first of some directions across which a bar can turn at a grid: the bar
/// of bar_joint() does not lie along it.
///
/// @param components 1..3 each, not empty
/// @return the first where it lies along all, or there is no bar
[[nodiscard]] int across_bar(const structure::Deck& deck,
                             int node,
                             const std::vector<int>& bars,
                             const std::vector<int>& components);

/// The joint between a bar and the rest at a grid.
///
/// @param bars ids of which one touches the grid (a bar, or what it was split
///   into); empty: any bar there
/// @param component 1..3, the direction measured: the bar turns across it
/// @return no grids where the bar lies along that direction
[[nodiscard]] JointLine bar_joint(const structure::Deck& deck,
                                  int node,
                                  const std::vector<int>& bars,
                                  int component);

}  // namespace tapfit::updating
