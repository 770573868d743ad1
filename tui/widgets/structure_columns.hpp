// A structure as it is drawn, in numbers: its grids, where they are, how they
// move, what their marks stand for.
#pragma once

#include "tui/widgets/drawing.hpp"
#include "tui/widgets/scene.hpp"

#include <vector>

namespace tapfit::tui {

/// A row per grid: its id, x, y and z [m]; the displacements of the model and
/// those measured, in the shape's scale; 1 where it is in the place that is
/// highlighted; the value of its mark. What is not drawn has no columns.
[[nodiscard]] std::vector<NamedNumbers> structure_columns(const Wireframe& wire,
                                                          const Scene& scene);

}  // namespace tapfit::tui
