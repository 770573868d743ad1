// What holds a structure, and what only keeps its model in a plane.
#pragma once

#include "updating/structure/deck/constraint_axes.hpp"
#include "updating/structure/deck/deck.hpp"

#include <string>

namespace tapfit::updating {

/// What is held at nine grids in ten keeps the model in its plane or on its
/// line, or is the turns of solids' grids: no support, which would give.
struct SupportAxes {
  structure::ConstraintAxes axes;  ///< without these; grids held in more
  std::string everywhere;          ///< these, digits along basic axes
};

/// @throws InputError for a constraint on a grid that does not exist
[[nodiscard]] SupportAxes support_axes(const structure::Deck& deck);

}  // namespace tapfit::updating
