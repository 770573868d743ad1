// Solids: CHEXA, CPENTA, CPYRAM, CTETRA with linear or quadratic edges. Linear
// hexahedra and wedges have inner modes, with which they bend as thin plates
// do:
//
//   e = B u + G a,   K = K_uu - K_ua K_aa^-1 K_au
//   G = (det J0 / det J) J0^-T (d mode / d xi - its mean)
//
// whose integral over the element vanishes, so that constant strains are
// exact on any shape. Mass: consistent, or lumped in the ratio of its diagonal
// (which is above zero at every grid of a quadratic element).
//
// Source: R. L. Taylor, P. J. Beresford, E. L. Wilson, "A non-conforming
// element for stress analysis", Int. J. Numer. Meth. Engng 10, 1976; E. Hinton,
// T. Rock, O. C. Zienkiewicz, "A note on mass lumping and related processes",
// Earthquake Engng Struct. Dyn. 4, 1976.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/solid_shapes.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Strain = Eigen::Matrix<double, 6, 3>;

// Grids that are there, and where.
struct Shape {
  std::size_t corners = 0;
  std::vector<bool> has_mid;
  std::vector<int> grids;
  Eigen::MatrixX3d X;  // their places
};

Shape shape_of(const Deck& deck, const Solid& solid) {
  Shape shape;
  shape.corners = solid.grids.size();
  for (const int id : solid.mids) shape.has_mid.push_back(id != 0);
  shape.grids = solid.all_grids();
  shape.X = deck.position_rows(shape.grids);
  // Far from the origin places would round off.
  const Eigen::RowVector3d middle = shape.X.colwise().mean();
  shape.X.rowwise() -= middle;
  return shape;
}

bool quadratic(const Shape& shape) {
  return shape.grids.size() > shape.corners;
}

[[noreturn]] void bad_shape(const Deck& deck, const Solid& solid) {
  throw InputError(
      "the solid is turned inside out or has no volume (its Jacobian is not "
      "above zero)",
      card_place(deck, solid.where, fmt::format("solid {}", solid.id)),
      "Check the order of its grids: seen from the second face, the first one "
      "goes round counter-clockwise; and that grids of edges lie near their "
      "middles.");
}

// Strains (exx, eyy, ezz, 2 exy, 2 eyz, 2 ezx) from slopes of one function.
Strain strain_of(const Eigen::RowVector3d& d) {
  Strain B = Strain::Zero();
  B(0, 0) = d.x();
  B(1, 1) = d.y();
  B(2, 2) = d.z();
  B(3, 0) = d.y();
  B(3, 1) = d.x();
  B(4, 1) = d.z();
  B(4, 2) = d.y();
  B(5, 0) = d.z();
  B(5, 2) = d.x();
  return B;
}

Matrix6 isotropic(const Material& m) {
  const double lame = m.E * m.nu / ((1.0 + m.nu) * (1.0 - 2.0 * m.nu));
  const double G = m.G > 0.0 ? m.G : m.E / (2.0 * (1.0 + m.nu));
  Matrix6 C = Matrix6::Zero();
  C.topLeftCorner<3, 3>().setConstant(lame);
  // E and NU, which a G of its own does not change.
  C.diagonal().head<3>().array() += m.E / (1.0 + m.nu);
  C.diagonal().tail<3>().setConstant(G);
  return C;
}

// Strains along other axes (columns of R) from those along basic ones.
Matrix6 strain_rotation(const Matrix3d& R) {
  constexpr std::array<std::array<Index, 2>, 6> pairs{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  Matrix6 T;
  for (Index row = 0; row < 6; ++row) {
    const auto [a, b] = pairs.at(static_cast<std::size_t>(row));
    for (Index col = 0; col < 6; ++col) {
      const auto [i, j] = pairs.at(static_cast<std::size_t>(col));
      // e_ab = sum over i, j of R_ia R_jb e_ij; shears are twice theirs.
      const double both = R(i, a) * R(j, b) + R(j, a) * R(i, b);
      T(row, col) = 0.5 * both * (row < 3 ? 1.0 : 2.0);
    }
  }
  return T;
}

// x from corner 1 to 2, z normal to the first face.
Matrix3d own_axes(const Shape& shape) {
  const Eigen::Vector3d x = (shape.X.row(1) - shape.X.row(0)).normalized();
  const Eigen::Vector3d side =
      (shape.X.row(shape.corners == 8 || shape.corners == 5 ? 3 : 2) -
       shape.X.row(0))
          .transpose();
  const Eigen::Vector3d z = x.cross(side).normalized();
  Matrix3d axes;
  axes << x, z.cross(x), z;
  return axes;
}

Matrix6 elasticity(const Deck& deck, const Solid& solid, const Shape& shape) {
  const SolidProperty& p = deck.solid_properties.at(solid.property);
  const Material& m = deck.materials.at(p.material);
  if (!(m.E > 0.0) || (!m.is_solid() && m.nu > 0.4999999)) {
    throw InputError(
        fmt::format("material {} (E = {}, NU = {}) has no stiffness of a solid",
                    p.material,
                    m.E,
                    m.nu),
        card_place(deck, m.where, fmt::format("MAT1 {}", p.material)),
        "Give E above zero, and NU below 0.5.");
  }
  if (!m.is_solid()) return isotropic(m);
  const Matrix6 T = strain_rotation(p.in_element ? own_axes(shape) : p.axes);
  return T.transpose() * m.solid * T;
}

Matrix3d jacobian(const Shape& shape, const SolidFunctions& f) {
  return f.slopes.transpose() * shape.X;  // row 0 is d/dxi
}

Eigen::Vector3d centre(std::size_t corners) {
  if (corners == 8) return Eigen::Vector3d::Zero();
  if (corners == 6) return {1.0 / 3.0, 1.0 / 3.0, 0.0};
  if (corners == 5) return {0.0, 0.0, 0.25};
  return Eigen::Vector3d::Constant(0.25);
}

// Natural slopes of the inner modes, averaged over the element.
Eigen::MatrixX3d mean_inner_slopes(std::size_t corners,
                                   const std::vector<SolidPoint>& points) {
  Eigen::MatrixX3d mean = 0.0 * inner_mode_slopes(corners, centre(corners));
  double volume = 0.0;
  for (const SolidPoint& point : points) {
    mean += point.weight * inner_mode_slopes(corners, point.at);
    volume += point.weight;
  }
  return mean / volume;
}

MatrixXd stiffness(const Deck& deck, const Solid& solid, const Shape& shape) {
  const Matrix6 C = elasticity(deck, solid, shape);
  const auto n = static_cast<Index>(shape.grids.size());
  const bool linear = !quadratic(shape);
  const int order = linear && shape.corners != 5 ? 2 : 3;
  const std::vector<SolidPoint> points = solid_points(shape.corners, order);
  const Eigen::MatrixX3d mean = mean_inner_slopes(shape.corners, points);
  const Index inner = linear ? 3 * mean.rows() : 0;
  const Matrix3d J0 = jacobian(
      shape,
      solid_functions(shape.corners, shape.has_mid, centre(shape.corners)));
  const Matrix3d J0i = J0.inverse();
  MatrixXd K = MatrixXd::Zero(3 * n + inner, 3 * n + inner);
  MatrixXd B(6, 3 * n + inner);
  for (const SolidPoint& point : points) {
    const SolidFunctions f =
        solid_functions(shape.corners, shape.has_mid, point.at);
    const Matrix3d J = jacobian(shape, f);
    const double det = J.determinant();
    if (!(det > 0.0)) bad_shape(deck, solid);
    const Eigen::MatrixX3d d = f.slopes * J.inverse().transpose();
    for (Index i = 0; i < n; ++i) {
      B.middleCols<3>(3 * i) = strain_of(d.row(i));
    }
    if (inner > 0) {
      const Eigen::MatrixX3d modes =
          (inner_mode_slopes(shape.corners, point.at) - mean) *
          J0i.transpose() * (J0.determinant() / det);
      for (Index k = 0; k < modes.rows(); ++k) {
        B.middleCols<3>(3 * (n + k)) = strain_of(modes.row(k));
      }
    }
    K.noalias() += point.weight * det * B.transpose() * (C * B);
  }
  if (inner == 0) return K;
  return K.topLeftCorner(3 * n, 3 * n) -
         K.topRightCorner(3 * n, inner) *
             K.bottomRightCorner(inner, inner)
                 .ldlt()
                 .solve(MatrixXd(K.bottomLeftCorner(inner, 3 * n)));
}

// Per grid and grid; the same in each direction.
MatrixXd mass(const Deck& deck, const Solid& solid, const Shape& shape) {
  const SolidProperty& p = deck.solid_properties.at(solid.property);
  const double rho = deck.materials.at(p.material).rho;
  const auto n = static_cast<Index>(shape.grids.size());
  MatrixXd M = MatrixXd::Zero(n, n);
  if (rho == 0.0) return M;
  const int order = shape.corners == 8 && !quadratic(shape) ? 2
                    : quadratic(shape)                      ? 4
                                                            : 3;
  double whole = 0.0;
  for (const SolidPoint& point : solid_points(shape.corners, order)) {
    const SolidFunctions f =
        solid_functions(shape.corners, shape.has_mid, point.at);
    const double dm = rho * point.weight * jacobian(shape, f).determinant();
    M += dm * f.values * f.values.transpose();
    whole += dm;
  }
  if (deck.coupled_mass) return M;
  const Eigen::VectorXd share = M.diagonal();
  return (share * (whole / share.sum())).asDiagonal();
}

}  // namespace

ElementMatrices solid_matrices(const Deck& deck, const Solid& solid) {
  const Shape shape = shape_of(deck, solid);
  const MatrixXd k = stiffness(deck, solid, shape);
  const MatrixXd m = mass(deck, solid, shape);
  const auto n = static_cast<Index>(shape.grids.size());
  ElementMatrices result{
      shape.grids, MatrixXd::Zero(6 * n, 6 * n), MatrixXd::Zero(6 * n, 6 * n)};
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      result.K.block<3, 3>(6 * i, 6 * j) = k.block<3, 3>(3 * i, 3 * j);
      result.M.block<3, 3>(6 * i, 6 * j).diagonal().setConstant(m(i, j));
    }
  }
  return result;
}

}  // namespace tapfit::structure
