#include "updating/structure/elements/shell_mass.hpp"

#include <Eigen/Dense>

namespace tapfit::structure {
namespace {

// Value of the field that each row stands for, from the element's 6n dofs:
// u, v, w, theta_x, theta_y.
Eigen::MatrixXd field_values(const Corners& xy,
                             const Eigen::Vector2d& at,
                             bool bends) {
  const Eigen::Index n = xy.rows();
  const Eigen::VectorXd N = corner_values(n, at);
  const Eigen::VectorXd W = deflection_values(xy, at);
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(5, 6 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index c = 0; c < 5; ++c) F(c, 6 * i + c) = N(i);
    if (!bends) continue;
    F(2, 6 * i + 2) = W(3 * i);
    // w,x = -theta_y and w,y = theta_x.
    F(2, 6 * i + 3) = W(3 * i + 2);
    F(2, 6 * i + 4) = -W(3 * i + 1);
  }
  return F;
}

}  // namespace

Eigen::MatrixXd shell_mass(const Corners& xy,
                           const ShellSection& section,
                           bool coupled) {
  const Eigen::Index n = xy.rows();
  const bool bends = section.bending.trace() > 0.0;
  Eigen::VectorXd density(5);
  density << section.mass, section.mass, section.mass, section.rotary,
      section.rotary;
  if (!bends) density.tail(2).setZero();
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  for (const GaussPoint& point : gauss_points(n, 4)) {
    const double dA = point.weight * jacobian(xy, point.at).determinant();
    if (coupled) {
      const Eigen::MatrixXd F = field_values(xy, point.at, bends);
      M += dA * F.transpose() * density.asDiagonal() * F;
      continue;
    }
    const Eigen::VectorXd N = corner_values(n, point.at);
    for (Eigen::Index i = 0; i < n; ++i) {
      M.diagonal().segment<3>(6 * i).array() += dA * section.mass * N(i);
    }
  }
  return M;
}

}  // namespace tapfit::structure
