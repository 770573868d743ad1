// The test's mesh laid over the model, by pairs that are named or by best fit.
#pragma once

#include "acquisition/bundle/test_geometry.hpp"
#include "updating/places/point_on_mesh.hpp"
#include "updating/structure/deck/deck.hpp"

#include <set>

namespace tapfit::updating {

/// @param used labels of its nodes that are measured at, one or more
/// @throws InputError for pairs of grids that the model does not have, on a
///   line, that do not fit each other, or in another unit; for a mesh that fits
///   in several ways, or that is not the model's as it is and is measured at
///   points on a line
[[nodiscard]] structure::LaidOver lay_over(
    const acquisition::TestGeometry& geometry,
    const std::set<int>& used,
    const structure::Deck& deck,
    const MeshSurface& surface);

}  // namespace tapfit::updating
