// CSHEAR: a panel that carries shear flow only, and as much of its area as the
// property says as rods along its sides. The flow goes with the shear at the
// middle,
//
//   U = 1/2 G t A (u,y + v,x)^2
//
// which is the exact one of a rectangle. Its mass is lumped.
//
// Source: S. J. Garvey, "The quadrilateral shear panel", Aircraft Engineering
// 23, 1951; MSC Nastran Quick Reference Guide, PSHEAR.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/shell_shapes.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Places = Eigen::Matrix<double, 4, 3>;

// A rod along one side, over the panel's translations.
void add_rod(const Places& X, Index a, double EA, MatrixXd& K) {
  const Index b = (a + 1) % 4;
  const Vector3d side = (X.row(b) - X.row(a)).transpose();
  const double L = side.norm();
  const Matrix3d k = EA / (L * L * L) * side * side.transpose();
  K.block<3, 3>(6 * a, 6 * a) += k;
  K.block<3, 3>(6 * b, 6 * b) += k;
  K.block<3, 3>(6 * a, 6 * b) -= k;
  K.block<3, 3>(6 * b, 6 * a) -= k;
}

// Area of each of the two rods along opposite sides: half of that share of the
// panel across them; a factor above 1.01 counts thicknesses.
double rod_area(double factor, double t, double width) {
  constexpr double counts = 1.01;
  return 0.5 * factor * t * (factor > counts ? t : width);
}

}  // namespace

ElementMatrices panel_matrices(const Deck& deck, const Shell& shell) {
  const ShellProperty& p = deck.shell_properties.at(shell.property);
  const Material& m = deck.materials.at(p.membrane);
  const Places X = deck.position_rows(shell.grids);
  const Vector3d d1 = (X.row(2) - X.row(0)).transpose();
  const Vector3d d2 = (X.row(3) - X.row(1)).transpose();
  const Vector3d normal = d1.cross(d2);
  if (!(normal.norm() > 1e-8 * d1.norm() * d2.norm())) {
    throw InputError(
        "the panel has no area",
        card_place(deck, shell.where, fmt::format("panel {}", shell.id)),
        "Check the order of its grids: they must go round it.");
  }
  const double area = 0.5 * normal.norm();
  const Vector3d z = normal.normalized();
  const Vector3d side = (X.row(1) - X.row(0)).transpose();
  const Vector3d x = (side - z * z.dot(side)).normalized();
  const Vector3d y = z.cross(x);
  Corners xy(4, 2);
  xy << X * x, X * y;
  const Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  const Corners d =
      corner_slopes(4, middle) * jacobian(xy, middle).inverse().transpose();
  Eigen::RowVectorXd shear = Eigen::RowVectorXd::Zero(24);
  for (Index k = 0; k < 4; ++k) {
    shear.segment<3>(6 * k) = (d(k, 1) * x + d(k, 0) * y).transpose();
  }
  ElementMatrices result{shell.grids,
                         m.G * p.thickness * area * shear.transpose() * shear,
                         MatrixXd::Zero(24, 24)};
  const auto width = [&](Index a) {
    const Index b = (a + 2) % 4;
    return 0.5 * ((X.row((a + 1) % 4) - X.row(a)).norm() +
                  (X.row((b + 1) % 4) - X.row(b)).norm());
  };
  for (const Index k : {0, 1, 2, 3}) {
    const double factor = p.extensional.at(static_cast<std::size_t>(k % 2));
    if (factor == 0.0) continue;
    const double A = rod_area(factor, p.thickness, width((k + 1) % 4));
    add_rod(X, k, m.E * A, result.K);
  }
  const double mass = (m.rho * p.thickness + p.nonstructural) * area;
  for (Index k = 0; k < 4; ++k) {
    result.M.diagonal().segment<3>(6 * k).setConstant(mass / 4.0);
  }
  return result;
}

}  // namespace tapfit::structure
