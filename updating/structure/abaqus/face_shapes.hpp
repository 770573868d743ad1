// Where a point lies on a face of an element, and the share that each node of
// the face has there.
//
//   x(xi, eta) = sum_i N_i(xi, eta) x_i,   |x(xi, eta) - p| least
//
// Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1,
// shape functions of serendipity quadrilaterals and of triangles.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::structure {

struct OnFace {
  Eigen::VectorXd shares;  ///< N_i, their sum is 1
  double distance = 0.0;   ///< from the point to the face
};

/// @param nodes places of its corners (3 or 4), then of the middles of its
///   sides, if any: 3, 4, 6 or 8 in all
/// @return empty where the point lies beside the face
[[nodiscard]] std::optional<OnFace> place_on_face(
    const std::vector<Eigen::Vector3d>& nodes, const Eigen::Vector3d& p);

}  // namespace tapfit::structure
