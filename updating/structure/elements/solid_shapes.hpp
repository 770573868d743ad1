// Shape functions of solids in natural coordinates, with their slopes, and
// Gauss points.
//
//   hexahedron   xi, eta, zeta in [-1, 1]
//   wedge        xi, eta >= 0, xi + eta <= 1, zeta in [-1, 1]
//   pyramid      zeta in [0, 1], |xi|, |eta| <= 1 - zeta
//   tetrahedron  xi, eta, zeta >= 0, xi + eta + zeta <= 1
//
// An edge's function is that of its middle; with it the functions of its ends
// lose half of it, so that any of the edges may have a grid in its middle:
//
//   N_corner = N_linear - 1/2 sum of its edges' functions
//
// Source: O. C. Zienkiewicz, R. L. Taylor, "The Finite Element Method", vol. 1,
// ch. 8; of the pyramid: G. Bedrosian, "Shape functions and integration
// formulas for three-dimensional finite element analysis", Int. J. Numer. Meth.
// Engng 35, 1992.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace tapfit::structure {

struct SolidPoint {
  Eigen::Vector3d at;
  double weight = 0.0;
};

/// Edges of a solid by its number of corners (8, 6, 5, 4), as pairs of corners
/// in the order in which cards name the grids in their middles.
[[nodiscard]] const std::vector<std::array<int, 2>>& solid_edges(
    std::size_t corners);

/// Gauss rule with `order` points along each coordinate (1 to 4), collapsed on
/// wedge, pyramid and tetrahedron.
[[nodiscard]] std::vector<SolidPoint> solid_points(std::size_t corners,
                                                   int order);

struct SolidFunctions {
  Eigen::VectorXd values;   ///< n
  Eigen::MatrixX3d slopes;  ///< natural, n x 3
};

/// Of the corners and of those edges that have a grid, in this order.
/// @param has_mid per edge; empty: none
[[nodiscard]] SolidFunctions solid_functions(std::size_t corners,
                                             const std::vector<bool>& has_mid,
                                             const Eigen::Vector3d& at);

/// Natural slopes of the inner modes by which linear hexahedra and wedges
/// bend: 1 - xi^2 and its like, on the wedge 1 - zeta^2 and the products of
/// area coordinates. Modes x 3; none for others.
[[nodiscard]] Eigen::MatrixX3d inner_mode_slopes(std::size_t corners,
                                                 const Eigen::Vector3d& at);

}  // namespace tapfit::structure
