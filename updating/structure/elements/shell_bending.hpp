// Bending and transverse shear of a flat shell: discrete Kirchhoff-Mindlin
// quadrilateral (DKMQ) and triangle (DKMT). Rotations vary quadratically along
// each side by an increment that side equilibrium ties to the corners:
//
//   (2/3) L (1 + phi) db = w_i - w_j - L/2 (b_s,i + b_s,j),
//   phi = 12 Db / (Ds L^2),   gamma_s = -(2/3) phi db
//
// so that a thin plate is Kirchhoff's (DKQ, DKT) and a thick one Mindlin's,
// without locking.
//
// Source: I. Katili, "A new discrete Kirchhoff-Mindlin element based on
// Mindlin-Reissner plate theory and assumed shear strain fields", parts I and
// II, Int. J. Numer. Meth. Engng 36, 1993, p. 1859-1908.
#pragma once

#include "updating/structure/elements/shell_section.hpp"
#include "updating/structure/elements/shell_shapes.hpp"

namespace tapfit::structure {

/// Curvatures over (w, theta_x, theta_y) of each corner, 3 x 3n, at each of
/// gauss_points(n, 2).
[[nodiscard]] std::vector<Eigen::MatrixXd> curvatures(
    const Corners& xy, const ShellSection& section);

/// Stiffness over (w, theta_x, theta_y) of each corner, 3n x 3n.
/// @param xy corners in the element's plane, counter-clockwise [m]
[[nodiscard]] Eigen::MatrixXd bending_stiffness(const Corners& xy,
                                                const ShellSection& section);

}  // namespace tapfit::structure
