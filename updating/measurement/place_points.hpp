// The test's own points put on the model: at coordinates, in skew directions,
// above the surface, or of a mesh that is laid over the model.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/structure/deck/deck.hpp"

#include <set>

namespace tapfit::updating {

/// Adds grids that follow the model's elements (see structure::MeasuringPoint).
///
/// @param used labels of the points that something is hit or measured at
/// @param deck in SI units; gains grids, relations, measuring and laid_over
/// @throws InputError for a point farther from every element than the element
///   is large, a height where the surface has no one normal, a coordinate
///   system, a grid or a point that is not there, and a mesh that lies on the
///   model in no way or in several
void place_points(const acquisition::TestBundle& bundle,
                  const std::set<int>& used,
                  structure::Deck& deck);

/// A measured direction in basic axes: of a grid's, or of a placed point's
/// component 1..6 (rotations about it).
[[nodiscard]] Eigen::Vector3d direction_of(const structure::Deck& deck,
                                           const Dof& dof);

}  // namespace tapfit::updating
