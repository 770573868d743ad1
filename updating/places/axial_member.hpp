// Members and strips that can be pulled along: bars in line from end to end,
// rods, and flat sheets of shells along their longest direction or the one
// across it.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// An end of a member.
struct MemberEnd {
  std::vector<int> grids;
  bool loose = false;  ///< nothing holds it, and nothing else is joined to it
};

struct AxialMember {
  std::array<MemberEnd, 2> ends;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< to the second end
  double length = 0.0;                              ///< along the axis [m]

  /// The loose end, which only something outside can pull at.
  [[nodiscard]] const MemberEnd* pulled() const;
  /// One with two loose ends is not.
  [[nodiscard]] bool can_be_pulled() const {
    return !(ends[0].loose && ends[1].loose);
  }
  /// Away from the structure.
  [[nodiscard]] Eigen::Vector3d outward() const {
    return ends[0].loose ? Eigen::Vector3d(-axis) : axis;
  }
};

/// The member that some elements make up, bars and rods or shells.
/// @param across of shells: along the shorter direction
/// @return empty where they have no two ends: a ring, a fork, no elements
[[nodiscard]] std::optional<AxialMember> axial_member(
    const structure::Deck& deck, const std::vector<int>& elements, bool across);

/// Elements of each member of the deck, ids ascending: whole runs of bars in
/// line, each rod, each sheet of shells that meet at gentle angles.
[[nodiscard]] std::vector<std::vector<int>> whole_members(
    const structure::Deck& deck);

}  // namespace tapfit::updating
