// The stiffness that an element has across the force it carries, over the six
// degrees of freedom of each of its grids, in basic axes [N/m, N, N m].
//
//   bar     K_g = N / (30 L) [ 36   3L   -36   3L  ]
//                            [ 3L   4L^2 -3L  -L^2 ]   over (w1, w1', w2, w2'),
//                            [-36  -3L    36  -3L  ]   in both planes
//                            [ 3L  -L^2  -3L   4L^2]
//   rod     K_g = N / L [1 -1; -1 1]
//   shell   K_g = int grad(phi_i)' N grad(phi_j) dA
//
// Source: J. S. Przemieniecki, "Theory of Matrix Structural Analysis", 1968,
// ch. 15; R. D. Cook et al., "Concepts and Applications of Finite Element
// Analysis", 2002, ch. 18.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::structure {

/// Over the degrees of freedom of the element's grids.
struct GeometricMatrix {
  std::vector<int> grids;
  Eigen::MatrixXd K;  ///< 6n x 6n, n = grids
};

/// Unit vector from end to end, offsets included.
[[nodiscard]] Eigen::Vector3d bar_axis(const Deck& deck, const Bar& bar);
[[nodiscard]] Eigen::Vector3d rod_axis(const Deck& deck, const Rod& rod);

/// Of a unit tension. A bar with pins is taken for a string.
[[nodiscard]] GeometricMatrix geometric_matrix(const Deck& deck,
                                               const Bar& bar);
[[nodiscard]] GeometricMatrix geometric_matrix(const Deck& deck,
                                               const Rod& rod);

/// @param N membrane force in basic axes, symmetric [N/m]
[[nodiscard]] GeometricMatrix geometric_matrix(const Deck& deck,
                                               const Shell& shell,
                                               const Eigen::Matrix3d& N);

/// What a shell of corners is in its own plane: axes of side 1-2, across it and
/// normal as columns, its area, and its membrane stiffness for (exx, eyy, 2
/// exy) [N/m], zero for a panel.
struct ShellPlane {
  Eigen::Matrix3d axes;
  double area = 0.0;
  Eigen::Matrix3d membrane = Eigen::Matrix3d::Zero();
  /// Mean slope of each corner's shape, in basic axes, n x 3 [1/m].
  Eigen::MatrixX3d slopes;
};
[[nodiscard]] ShellPlane shell_plane(const Deck& deck, const Shell& shell);

/// Membrane force of displacements of the corners, in basic axes [N/m].
/// @param u n x 3
[[nodiscard]] Eigen::Matrix3d membrane_force(const ShellPlane& plane,
                                             const Eigen::MatrixX3d& u);

}  // namespace tapfit::structure
