// What is held, and which axes its components count along. What follows a grid
// that is held wholly by a rigid element is held like it. A card's digits are
// along the grid's displacement axes (CD). Where what is held spans basic axes
// (a clamp, a turn by 90 degrees), they are said along those, and the grid
// needs no axes of its own; elsewhere it is solved in turned axes.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>

namespace tapfit::structure {

struct ConstraintAxes {
  std::set<int> turned;  ///< grids that are solved along their own axes
  /// Per grid the components held at zero, digits of 1..6: along the grid's own
  /// axes where it is turned, else along basic axes.
  std::map<int, std::string> held;

  /// Components held along basic axes; none at turned grids.
  [[nodiscard]] std::string held_in_basic(int grid) const;

  /// In all six components.
  [[nodiscard]] bool held_wholly(int grid) const;
};

/// Per grid the components held at zero, along its own axes.
[[nodiscard]] std::map<int, std::string> held_by_grid(const Deck& deck);

/// @throws InputError for a constraint on a grid that does not exist
[[nodiscard]] ConstraintAxes constraint_axes(const Deck& deck);

/// Components along turned axes as components along basic axes; empty when
/// they span no basic axes.
[[nodiscard]] std::optional<std::string> along_basic(
    const std::string& components, const Eigen::Matrix3d& axes);

}  // namespace tapfit::structure
