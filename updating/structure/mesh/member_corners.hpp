// Where members of bars meet at an angle. A bar is drawn to the point where the
// lines cross; its last piece lies inside the members it meets:
//
//   z = max over the others of reach / sin(angle)   [m]
//
// reach: how far the other's section extends from its line, sqrt(3 I / A) of a
// rectangle.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace tapfit::structure {

/// Sine of the angle from which members meet at a corner: those below go on in
/// each other, as around a curve.
inline constexpr double corner_sine = 0.35;

/// Of an element that lies inside others at most this is taken away, so that
/// something is left that bends and weighs.
inline constexpr double largest_share = 0.9;

/// A bar as a box: its line, and how far its section reaches from it.
struct Member {
  std::size_t bar = 0;                    ///< index in the deck
  std::array<Eigen::Vector3d, 2> ends{};  ///< [m]
  Eigen::Vector3d x, y, z;                ///< its axes, of length 1
  double length = 0.0;                    ///< [m]
  double half_y = 0.0;                    ///< [m]
  double half_z = 0.0;                    ///< [m]

  /// How far it reaches from its own line along u [m].
  [[nodiscard]] double reach(const Eigen::Vector3d& u) const;
};

/// The end of a line of bars that lies inside others.
struct CornerEnd {
  int grid = 0;
  std::size_t own = 0;      ///< index of the member that ends there
  Eigen::Vector3d along;    ///< away from the grid, of length 1
  double length = 0.0;      ///< z [m]
  bool in_through = false;  ///< one of the others goes on behind it
  std::size_t meeting = 0;  ///< members at the grid
  /// Members it runs over (several in a fine mesh) and the share of each.
  std::vector<std::pair<std::size_t, double>> inside;
};

/// The corners of a deck.
struct MemberCorners {
  std::vector<Member> members;
  std::vector<CornerEnd> ends;
};

/// @return members without a section, length or orientation are left out
[[nodiscard]] MemberCorners member_corners(const Deck& deck);

}  // namespace tapfit::structure
