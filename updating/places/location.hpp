// The room updating/places. Where something may sit in a structure: supports,
// joints, patches of elements, and what is near what.
// In:  Deck.
// Out: Location lists. What sits there is decided in updating/effects.
// May include: its row in CONTRIBUTING.md.
//
// Where an effect sits on the structure or in the measuring chain.
#pragma once

#include <string>
#include <vector>

namespace tapfit::updating {

/// Where an effect sits; which member is used depends on the effect.
struct Location {
  int node = 0;  ///< 0: not used
  std::vector<int> nodes = {};
  std::vector<int> elements = {};
  std::vector<std::string> channels = {};
  /// Which form of the effect, where it has several: "rotation",
  /// "translation"; "each" for one mass per channel instead of a shared one;
  /// "X", "Y" or "Z" for an axis that is not the one mostly measured;
  /// "rotary" for a mass with an inertia, a sensor's or another; "pocket" for
  /// elements that were thinned, "edges" where the ends of what is lost lie
  /// within elements; "crack" for a joint whose sides part.
  std::string variant = {};
  /// Between grids: coordinates in basic axes [m], three or none; node is then
  /// the nearest grid of the element that holds them.
  std::vector<double> at = {};
  /// Of a mistake of the sheet: the runs in which it was made, counted from 1,
  /// ascending; empty: all. Its `channels` are then where the sheet has them,
  /// at the grid in `nodes`, and `node` is where they were.
  std::vector<int> runs = {};

  bool operator==(const Location&) const = default;
};

/// Form of a loss of stiffness that takes the mass with it.
inline const std::string pocket = "pocket";

/// Forms of a loss whose edges lie between grids, mass kept and taken.
inline const std::string edges = "edges";
inline const std::string pocket_edges = "pocket-edges";

/// Whether elements that have lost stiffness there have lost mass, too.
[[nodiscard]] bool takes_mass(const Location& where);

/// Whether elements beside those there have lost some of theirs.
[[nodiscard]] bool has_edges(const Location& where);

/// Form of a joint along part of a line, whose sides part.
inline const std::string crack = "crack";

/// Whether the variant is an axis that the effect acts along.
[[nodiscard]] bool is_along_axis(const Location& where);

/// Whether something of the structure sits there, at a grid.
[[nodiscard]] bool is_at_grid(const Location& where);

/// Whether the variant is a direction with its sign, "+X".
[[nodiscard]] bool is_direction(const Location& where);

/// "node 201", "node 201 along X", "acc1, acc2", "19 nodes (1 ... 38)"; of a
/// mistake "acc1 at node 6, not 8, in runs 4 to 6".
[[nodiscard]] std::string describe(const Location& where);

}  // namespace tapfit::updating
