#include "updating/structure/elements/shell_membrane.hpp"

#include <Eigen/Dense>

#include <utility>

namespace tapfit::structure {
namespace {

// gamma: a tenth holds what turns one grid, and still stiffens a box of single
// elements, whose rotations jump from one to the next, by 1e-4.
constexpr double drilling_factor = 0.1;

// Strains (exx, eyy, 2 exy) of one function's u and v from its slopes.
Eigen::Matrix<double, 3, 2> strain_of(double dx, double dy) {
  Eigen::Matrix<double, 3, 2> B;
  B << dx, 0.0, 0.0, dy, dy, dx;
  return B;
}

// Slopes of the two inner modes (1 - xi^2, 1 - eta^2) with the Jacobian of the
// centre, which makes the element pass the patch test on any quadrilateral.
Corners inner_slopes(const Corners& xy,
                     const Eigen::Vector2d& at,
                     double area_ratio) {
  const Eigen::Matrix2d J0 = jacobian(xy, Eigen::Vector2d::Zero());
  const Eigen::Matrix2d J0i = J0.inverse();
  Corners slopes(2, 2);
  for (Eigen::Index k = 0; k < 2; ++k) {
    slopes.row(k) = J0i.col(k) * (-2.0 * at(k) * J0.determinant() / area_ratio);
  }
  return slopes;
}

// theta_z - (v,x - u,y) / 2 over the corners' u, v, theta_z.
Eigen::RowVectorXd drilling(const Corners& dN, const Eigen::VectorXd& N) {
  Eigen::RowVectorXd row(3 * N.size());
  for (Eigen::Index i = 0; i < N.size(); ++i) {
    row.segment<3>(3 * i) << 0.5 * dN(i, 1), -0.5 * dN(i, 0), N(i);
  }
  return row;
}

// Derivatives of the corners' functions to x and y.
Corners slopes(const Corners& xy, const Eigen::Vector2d& at) {
  return corner_slopes(xy.rows(), at) * jacobian(xy, at).inverse().transpose();
}

}  // namespace

Eigen::MatrixXd condensed(const Eigen::MatrixXd& K, Eigen::Index inner) {
  const Eigen::Index n = K.rows() - inner;
  if (inner == 0) return K;
  return K.topLeftCorner(n, n) -
         K.topRightCorner(n, inner) * K.bottomRightCorner(inner, inner)
                                          .ldlt()
                                          .solve(K.bottomLeftCorner(inner, n));
}

MembraneParts membrane_parts(const Corners& xy, const ShellSection& section) {
  const Eigen::Index n = xy.rows();
  const Eigen::Index inner = n == 4 ? 4 : 0;
  MembraneParts parts;
  parts.inner = inner;
  const double G = section.membrane(2, 2);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * n + inner, 3 * n + inner);
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(3, 3 * n + inner);
  Eigen::RowVectorXd drill(3 * n + inner);
  for (const GaussPoint& point : gauss_points(n, 2)) {
    const Eigen::Matrix2d J = jacobian(xy, point.at);
    const double dA = point.weight * J.determinant();
    const Corners dN = slopes(xy, point.at);
    for (Eigen::Index i = 0; i < n; ++i) {
      B.middleCols<2>(3 * i) = strain_of(dN(i, 0), dN(i, 1));
    }
    drill.head(3 * n) = drilling(dN, corner_values(n, point.at));
    if (inner > 0) {
      const Corners I = inner_slopes(xy, point.at, J.determinant());
      for (Eigen::Index k = 0; k < 2; ++k) {
        B.middleCols<2>(3 * n + 2 * k) = strain_of(I(k, 0), I(k, 1));
        drill.segment<2>(3 * n + 2 * k) << 0.5 * I(k, 1), -0.5 * I(k, 0);
      }
    }
    K += dA * B.transpose() * section.membrane * B;
    K += dA * drilling_factor * G * drill.transpose() * drill;
    parts.strains.push_back(B);
  }
  parts.K = std::move(K);
  return parts;
}

Eigen::MatrixXd membrane_stiffness(const Corners& xy,
                                   const ShellSection& section) {
  const MembraneParts parts = membrane_parts(xy, section);
  return condensed(parts.K, parts.inner);
}

}  // namespace tapfit::structure
