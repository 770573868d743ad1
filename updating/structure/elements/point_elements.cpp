// Concentrated masses, springs and masses on single degrees of freedom.
#include "updating/structure/elements/element_matrices.hpp"

#include <Eigen/Dense>

namespace tapfit::structure {

ElementMatrices mass_matrices(const PointMass& mass) {
  const Eigen::Vector3d& r = mass.offset;
  Eigen::Matrix3d cross;
  cross << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  Eigen::MatrixXd M(6, 6);
  M.topLeftCorner<3, 3>() = mass.mass * Eigen::Matrix3d::Identity();
  M.topRightCorner<3, 3>() = -mass.mass * cross;
  M.bottomLeftCorner<3, 3>() = mass.mass * cross;
  M.bottomRightCorner<3, 3>() = mass.inertia - mass.mass * cross * cross;
  if (mass.matrix.size() > 0) M += mass.matrix;
  return {{mass.grid}, Eigen::MatrixXd::Zero(6, 6), M};
}

Eigen::VectorXd scalar_direction(const ScalarElement& scalar) {
  Eigen::VectorXd direction(0);
  double sign = scalar.grids[0] != 0 && scalar.grids[1] != 0 ? -1.0 : 1.0;
  for (std::size_t end = 0; end < 2; ++end) {
    if (scalar.grids[end] == 0) continue;
    const Eigen::Index from = direction.size();
    direction.conservativeResize(from + 6);
    direction.tail(6).setZero();
    const Eigen::Index component = scalar.components[end] - 1;
    if (scalar.axes[end].isZero()) {
      direction(from + component) = sign;
    } else {
      direction.segment<3>(from + component / 3 * 3) = sign * scalar.axes[end];
    }
    sign = 1.0;
  }
  return direction;
}

// A scalar mass between two grids acts on their relative motion, as CMASS2.
ElementMatrices scalar_matrices(const ScalarElement& scalar) {
  const Eigen::VectorXd b = scalar_direction(scalar);
  ElementMatrices result;
  for (const int grid : scalar.grids) {
    if (grid != 0) result.grids.push_back(grid);
  }
  result.K = scalar.stiffness * b * b.transpose();
  result.M = scalar.mass * b * b.transpose();
  return result;
}

}  // namespace tapfit::structure
