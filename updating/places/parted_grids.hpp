// Motions that a model has besides those of its grids: what parts at a joint or
// a crack, and what follows a held grid that gives way.
#pragma once

#include "updating/places/location.hpp"
#include "updating/places/support_line.hpp"
#include "updating/structure/mesh/refined_deck.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace tapfit::updating {

/// One motion of its own, and how much of what holds it is there.
struct Parting {
  using Motion = Eigen::Matrix<double, 6, 1>;  ///< along basic axes

  std::vector<std::pair<int, Motion>> moves;  ///< of each grid
  double held = 0.0;
  std::size_t part = 0;  ///< which of the change's stiffnesses holds it
};

struct Cut {
  std::vector<Parting> partings;
  std::vector<int> side;  ///< elements that move so; none: all on these grids
};

/// A joint or a crack, on the mesh that is solved.
/// @param component 1..3, the direction measured
[[nodiscard]] Cut cut_at(const structure::RefinedDeck& mesh,
                         const Location& where,
                         int component);

/// A grid that is held and leads others by rigid elements, where it gives way:
/// it and all that follows it move as one body.
/// @param parts of the support, see support_parts()
[[nodiscard]] Cut hub_let_go(const structure::Deck& deck,
                             const std::vector<SupportPart>& parts);

}  // namespace tapfit::updating
