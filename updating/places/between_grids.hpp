// Places between grids: on a bar, or on a shell's surface. What moves there is
// told by the element's shape functions (element_shapes.hpp), rotations of its
// grids included.
#pragma once

#include "updating/places/element_shapes.hpp"
#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// Part of a motion that is one of a grid's own.
struct MotionShare {
  int node = 0;
  int component = 3;  ///< 1..6, basic axes
  double weight = 0.0;

  bool operator==(const MotionShare&) const = default;
};

/// Adds what a grid's motion and turning have in a motion.
void add_shares(int grid,
                const CornerMotion& motion,
                std::vector<MotionShare>& shares);

/// The motion along a basic axis at a place between grids, as a sum of motions
/// of the grids of the element that holds it.
///
/// @param where at and node, one of that element's grids
/// @param component 1..3
/// @return empty where no element at the node holds the place
[[nodiscard]] std::vector<MotionShare> motion_between(
    const structure::Deck& deck, const Location& where, int component);

/// How far a grid is from the place's node, in sides of an element there: 1 or
/// more, 1 of those that an element joins.
[[nodiscard]] double sides_apart(const Location& where,
                                 int grid,
                                 const structure::Deck& deck);

/// Places around one, on the way to each grid that an element joins to its
/// node; none on solids.
///
/// @param step of the way; beyond the element, 1 or more, to the grid next to
///   there
[[nodiscard]] std::vector<Location> places_around(const Location& where,
                                                  double step,
                                                  const structure::Deck& deck);

/// The same effect at other coordinates: on the element that holds them; or
/// empty where none at its node, at the next grid or beside them does.
///
/// @param at basic axes [m]
[[nodiscard]] std::vector<Location> moved_to(const Location& where,
                                             const Eigen::Vector3d& at,
                                             const structure::Deck& deck);

/// Its coordinates, a grid's or its own [m].
[[nodiscard]] Eigen::Vector3d position_of(const Location& where,
                                          const structure::Deck& deck);

}  // namespace tapfit::updating
