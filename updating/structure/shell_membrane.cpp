#include "updating/structure/shell_membrane.hpp"

#include <Eigen/Dense>

namespace tapfit::structure {
namespace {

// gamma for the mean over the element, which in-plane bending does not turn,
// and for the rest: Nastran's K6ROT = 100.
constexpr double kDrillingCentre = 1.0;
constexpr double kDrillingSpread = 1e-4;

// Strains (exx, eyy, 2 exy) of one function's u and v from its slopes.
Eigen::Matrix<double, 3, 2> strain_of(double dx, double dy) {
  Eigen::Matrix<double, 3, 2> B;
  B << dx, 0.0, 0.0, dy, dy, dx;
  return B;
}

// Two inner modes (1 - xi^2, 1 - eta^2) with the Jacobian of the centre, which
// makes the element pass the patch test on any quadrilateral.
Eigen::Matrix<double, 3, 4> incompatible(const Corners& xy,
                                         const Eigen::Vector2d& at,
                                         double area_ratio) {
  const Eigen::Matrix2d J0 = jacobian(xy, Eigen::Vector2d::Zero());
  const Eigen::Matrix2d J0i = J0.inverse();
  Eigen::Matrix<double, 3, 4> B;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Eigen::Vector2d slope =
        J0i.col(k) * (-2.0 * at(k) * J0.determinant() / area_ratio);
    B.middleCols<2>(2 * k) = strain_of(slope.x(), slope.y());
  }
  return B;
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

Eigen::MatrixXd membrane_stiffness(const Corners& xy,
                                   const ShellSection& section) {
  const Eigen::Index n = xy.rows();
  const Eigen::Index inner = n == 4 ? 4 : 0;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  Eigen::MatrixXd Kab = Eigen::MatrixXd::Zero(3 * n, inner);
  Eigen::MatrixXd Kaa = Eigen::MatrixXd::Zero(inner, inner);
  const double G = section.membrane(2, 2);
  double area = 0.0;
  for (const GaussPoint& point : gauss_points(n, 2)) {
    const Eigen::Matrix2d J = jacobian(xy, point.at);
    const double dA = point.weight * J.determinant();
    area += dA;
    const Corners dN = slopes(xy, point.at);
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(3, 3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      B.middleCols<2>(3 * i) = strain_of(dN(i, 0), dN(i, 1));
    }
    K += dA * B.transpose() * section.membrane * B;
    const Eigen::RowVectorXd drill = drilling(dN, corner_values(n, point.at));
    K += dA * kDrillingSpread * G * drill.transpose() * drill;
    if (inner == 0) continue;
    const Eigen::MatrixXd I = incompatible(xy, point.at, J.determinant());
    Kab += dA * B.transpose() * section.membrane * I;
    Kaa += dA * I.transpose() * section.membrane * I;
  }
  const Eigen::Vector2d centre =
      Eigen::Vector2d::Constant(n == 3 ? 1.0 / 3.0 : 0.0);
  const Eigen::RowVectorXd drill =
      drilling(slopes(xy, centre), corner_values(n, centre));
  K += area * kDrillingCentre * G * drill.transpose() * drill;
  if (inner > 0) K -= Kab * Kaa.ldlt().solve(Kab.transpose());
  return K;
}

}  // namespace tapfit::structure
