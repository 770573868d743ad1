#include "updating/structure/elements/shell_bending.hpp"

#include <Eigen/Dense>

namespace tapfit::structure {
namespace {

// What each side adds to the corners' rotations, n sides.
struct Sides {
  Eigen::MatrixXd increment;  // n x 3n: db from the corner values
  Eigen::VectorXd shear;      // n: line integral of gamma per db [m]
  Corners direction;          // n x 2, unit
};

Sides make_sides(const Corners& xy, const ShellSection& section) {
  const Eigen::Index n = xy.rows();
  Sides sides{
      Eigen::MatrixXd::Zero(n, 3 * n), Eigen::VectorXd::Zero(n), Corners(n, 2)};
  const Eigen::Matrix3d bending = section.least_bending();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index j = (i + 1) % n;
    const Eigen::Vector2d side = (xy.row(j) - xy.row(i)).transpose();
    const double L = side.norm();
    const Eigen::Vector2d d = side / L;
    const Eigen::Vector3d along(
        d.x() * d.x(), d.y() * d.y(), 2.0 * d.x() * d.y());
    const double Db = along.dot(bending * along);
    const double flexible = d.dot(section.shear_compliance * d);
    const double phi = 12.0 * Db * flexible / (L * L);
    const double scale = 1.5 / (L * (1.0 + phi));
    sides.increment(i, 3 * i) = scale;
    sides.increment(i, 3 * j) = -scale;
    // beta_x = theta_y, beta_y = -theta_x.
    for (const Eigen::Index corner : {i, j}) {
      sides.increment(i, 3 * corner + 1) = 0.5 * scale * side.y();
      sides.increment(i, 3 * corner + 2) = -0.5 * scale * side.x();
    }
    sides.shear(i) = -2.0 / 3.0 * phi * L;
    sides.direction.row(i) = d.transpose();
  }
  return sides;
}

// Curvatures (beta_x,x; beta_y,y; beta_x,y + beta_y,x), 3 x 3n.
Eigen::MatrixXd curvature(const Sides& sides,
                          const Corners& dN,
                          const Corners& dP) {
  const Eigen::Index n = dN.rows();
  Eigen::MatrixXd per_side(3, n);
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(3, 3 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double C = sides.direction(k, 0);
    const double S = sides.direction(k, 1);
    per_side.col(k) << dP(k, 0) * C, dP(k, 1) * S, dP(k, 1) * C + dP(k, 0) * S;
    B.col(3 * k + 1) << 0.0, -dN(k, 1), -dN(k, 0);
    B.col(3 * k + 2) << dN(k, 0), 0.0, dN(k, 1);
  }
  return B + per_side * sides.increment;
}

}  // namespace

std::vector<Eigen::MatrixXd> curvatures(const Corners& xy,
                                        const ShellSection& section) {
  const Eigen::Index n = xy.rows();
  const Sides sides = make_sides(xy, section);
  std::vector<Eigen::MatrixXd> result;
  for (const GaussPoint& point : gauss_points(n, 2)) {
    const Eigen::Matrix2d Ji = jacobian(xy, point.at).inverse();
    const Corners dN = corner_slopes(n, point.at) * Ji.transpose();
    const Corners dP = bubble_slopes(n, point.at) * Ji.transpose();
    result.push_back(curvature(sides, dN, dP));
  }
  return result;
}

Eigen::MatrixXd bending_stiffness(const Corners& xy,
                                  const ShellSection& section) {
  const Eigen::Index n = xy.rows();
  const Sides sides = make_sides(xy, section);
  const bool sheared = section.shear_compliance.trace() > 0.0;
  Eigen::Matrix2d Ds = Eigen::Matrix2d::Zero();
  if (sheared) {
    // An axis that is stiff in shear is given a compliance that is not felt.
    const double least = 1e-6 * section.shear_compliance.trace();
    Ds = (section.shear_compliance + least * Eigen::Matrix2d::Identity())
             .inverse();
  }
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (const GaussPoint& point : gauss_points(n, 2)) {
    const Eigen::Matrix2d J = jacobian(xy, point.at);
    const Eigen::Matrix2d Ji = J.inverse();
    const double dA = point.weight * J.determinant();
    // Derivatives to x and y: Ji applied to natural ones.
    const Corners dN = corner_slopes(n, point.at) * Ji.transpose();
    const Corners dP = bubble_slopes(n, point.at) * Ji.transpose();
    const Eigen::MatrixXd B = curvature(sides, dN, dP);
    K += dA * B.transpose() * section.bending * B;
    if (!sheared) continue;
    const Eigen::MatrixXd gamma = Ji * side_fields(n, point.at).transpose() *
                                  sides.shear.asDiagonal() * sides.increment;
    K += dA * gamma.transpose() * Ds * gamma;
  }
  return K;
}

}  // namespace tapfit::structure
