// Shape functions of the four-sided and three-sided shell in natural
// coordinates, and Gauss points. A quad runs over [-1, 1]^2, a triangle over
// xi, eta >= 0, xi + eta <= 1. Side k joins corner k to corner k + 1.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::structure {

using Corners = Eigen::Matrix<double, Eigen::Dynamic, 2>;  ///< n x 2, n = 3, 4

struct GaussPoint {
  Eigen::Vector2d at;
  double weight = 0.0;
};

/// Product Gauss rule of `order` x `order` points (1 to 4), collapsed onto the
/// triangle; exact for polynomials of degree 2 order - 2 on the triangle.
[[nodiscard]] std::vector<GaussPoint> gauss_points(Eigen::Index corners,
                                                   int order);

/// Gauss rule of 1 to 4 points over [-1, 1], the coordinate first.
[[nodiscard]] std::vector<GaussPoint> line_points(int order);

/// Corner functions, n.
[[nodiscard]] Eigen::VectorXd corner_values(Eigen::Index corners,
                                            const Eigen::Vector2d& at);

/// Their natural derivatives, n x 2.
[[nodiscard]] Corners corner_slopes(Eigen::Index corners,
                                    const Eigen::Vector2d& at);

/// Natural derivatives of the side bubbles (1 at mid side), n x 2.
[[nodiscard]] Corners bubble_slopes(Eigen::Index corners,
                                    const Eigen::Vector2d& at);

/// Covariant vector field with line integral 1 along side k and 0 along the
/// others; row k, n x 2.
[[nodiscard]] Corners side_fields(Eigen::Index corners,
                                  const Eigen::Vector2d& at);

/// Jacobian d(x, y)/d(xi, eta): row 0 is d/dxi.
[[nodiscard]] Eigen::Matrix2d jacobian(const Corners& xy,
                                       const Eigen::Vector2d& at);

/// Cubic deflection from w, dw/dx, dw/dy of each corner (3n, corner by
/// corner): Adini-Clough-Melosh on the quad, Bazeley et al. on the triangle.
/// Reproduces every linear w, and every quadratic one on parallelograms.
[[nodiscard]] Eigen::VectorXd deflection_values(const Corners& xy,
                                                const Eigen::Vector2d& at);

}  // namespace tapfit::structure
