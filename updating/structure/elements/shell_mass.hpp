// Mass of a flat shell. Consistent: linear in the plane, cubic deflection with
// the corner slopes across it (the deflection that goes with discrete
// Kirchhoff rotations, so that mass adds no error of its own order) and rotary
// inertia. Lumped: translations only.
#pragma once

#include "updating/structure/elements/shell_section.hpp"
#include "updating/structure/elements/shell_shapes.hpp"

namespace tapfit::structure {

/// Mass over (u, v, w, theta_x, theta_y, theta_z) of each corner, 6n x 6n.
[[nodiscard]] Eigen::MatrixXd shell_mass(const Corners& xy,
                                         const ShellSection& section,
                                         bool coupled);

}  // namespace tapfit::structure
