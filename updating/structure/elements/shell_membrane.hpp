// Membrane of a flat shell: bilinear quadrilateral with incompatible modes
// (QM6), constant strain triangle; both with a tie between the drilling
// rotation and the rotation of the plane,
//
//   U = 1/2 gamma G t  integral (theta_z - (v,x - u,y)/2)^2 dA.
//
// Source: R. L. Taylor, P. J. Beresford, E. L. Wilson, "A non-conforming
// element for stress analysis", Int. J. Numer. Meth. Engng 10, 1976; T. J. R.
// Hughes, F. Brezzi, "On drilling degrees of freedom", Comput. Methods Appl.
// Mech. Engng 72, 1989. gamma is 0.1; the inner modes of a quadrilateral turn
// the plane, too. A weak tie (Nastran's K6ROT = 100 is 1e-4) lets twisted
// surfaces go soft where elements are smaller than the thickness.
#pragma once

#include "updating/structure/elements/shell_section.hpp"
#include "updating/structure/elements/shell_shapes.hpp"

namespace tapfit::structure {

/// Stiffness with the inner modes still in it, they last.
struct MembraneParts {
  Eigen::MatrixXd K;                     ///< (3n + inner) square
  std::vector<Eigen::MatrixXd> strains;  ///< 3 x (3n + inner) at each of
                                         ///< gauss_points(n, 2)
  Eigen::Index inner = 0;
};
[[nodiscard]] MembraneParts membrane_parts(const Corners& xy,
                                           const ShellSection& section);

/// Takes the last entries, which carry no load, out of K.
[[nodiscard]] Eigen::MatrixXd condensed(const Eigen::MatrixXd& K,
                                        Eigen::Index inner);

/// Stiffness over (u, v, theta_z) of each corner, 3n x 3n.
/// @param xy corners in the element's plane, counter-clockwise [m]
[[nodiscard]] Eigen::MatrixXd membrane_stiffness(const Corners& xy,
                                                 const ShellSection& section);

}  // namespace tapfit::structure
