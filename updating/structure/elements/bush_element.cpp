// CBUSH: six springs at one point, which rigid arms join to two grids.
//
//   e = R' (u_B + theta_B x a_B - u_A - theta_A x a_A),   R' (theta_B -
//   theta_A)
#include "updating/structure/elements/element_matrices.hpp"

#include <Eigen/Dense>

namespace tapfit::structure {

Eigen::MatrixXd bush_strains(const Bush& bush) {
  Eigen::MatrixXd D(6, 0);
  for (std::size_t end = 0; end < 2; ++end) {
    if (bush.grids[end] == 0) continue;
    const Eigen::Vector3d& a = bush.arms[end];
    Eigen::Matrix3d arm;  // theta x a = arm theta
    arm << 0.0, a.z(), -a.y(), -a.z(), 0.0, a.x(), a.y(), -a.x(), 0.0;
    const double sign = end == 0 ? -1.0 : 1.0;
    const Eigen::Matrix3d R = sign * bush.axes.transpose();
    D.conservativeResize(6, D.cols() + 6);
    D.rightCols<6>().setZero();
    D.rightCols<6>().topLeftCorner<3, 3>() = R;
    D.rightCols<6>().topRightCorner<3, 3>() = R * arm;
    D.rightCols<6>().bottomRightCorner<3, 3>() = R;
  }
  return D;
}

ElementMatrices bush_matrices(const Bush& bush) {
  const Eigen::MatrixXd D = bush_strains(bush);
  ElementMatrices result;
  for (const int grid : bush.grids) {
    if (grid != 0) result.grids.push_back(grid);
  }
  const Eigen::Map<const Eigen::VectorXd> k(bush.stiffness.data(), 6);
  result.K = D.transpose() * k.asDiagonal() * D;
  result.M = Eigen::MatrixXd::Zero(D.cols(), D.cols());
  return result;
}

}  // namespace tapfit::structure
