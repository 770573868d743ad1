// CQUAD8 and CTRIA6: curved Mindlin shells. At each point of the surface the
// tangent plane e1, e2 and the normal n are taken as fixed, and with N and R
// the shape functions, u and theta those of the grids,
//
//   membrane  N,a u . e_b
//   bending   R,a (theta x n) . e_b
//   shear     N,a u . n + R (theta x n) . e_a
//   drilling  R theta . n - (N,1 u . e2 - N,2 u . e1) / 2
//
// so that a rigid motion strains nothing on any surface. Turns of a
// quadrilateral have one more function, in its middle (the "heterosis"
// element), and its shear 2 x 2 points: it does not lock when it is thin. Nor
// does the membrane of a curved one, most of which is integrated with 2 x 2
// points, too. Triangles bend as four linear ones.
//
// Source: T. J. R. Hughes, M. Cohen, "The heterosis finite element for plate
// bending", Computers & Structures 9, 1978, p. 445; S. Ahmad, B. M. Irons, O.
// C. Zienkiewicz, "Analysis of thick and thin shell structures by curved finite
// elements", Int. J. Numer. Meth. Engng 2, 1970.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/shell_membrane.hpp"
#include "updating/structure/elements/shell_section.hpp"
#include "updating/structure/elements/shell_shapes.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

// What of the membrane takes full integration, and the tie of the drilling
// rotation.
constexpr double full = 0.05;
constexpr double drilling_tie = 1e-3;

struct Surface {
  Index corners = 0;
  std::vector<bool> has_mid;
  std::vector<int> grids;
  Eigen::MatrixX3d X;
};

Surface surface_of(const Deck& deck, const Shell& shell) {
  Surface s;
  s.corners = static_cast<Index>(shell.grids.size());
  for (const int id : shell.mids) s.has_mid.push_back(id != 0);
  s.grids = shell.all_grids();
  s.X = deck.position_rows(s.grids);
  const Eigen::RowVector3d middle = s.X.colwise().mean();
  s.X.rowwise() -= middle;
  return s;
}

// Functions of the sides' middles: those of side_bubbles on the quadrilateral
// 1/2 (1 - xi^2) (1 - eta) and so on, 4 L_i L_j on the triangle.
Eigen::VectorXd side_values(Index corners, const Vector2d& at) {
  Eigen::VectorXd values(corners);
  if (corners == 3) {
    const Vector3d L(1.0 - at.x() - at.y(), at.x(), at.y());
    values << 4 * L(0) * L(1), 4 * L(1) * L(2), 4 * L(2) * L(0);
    return values;
  }
  const double x = at.x();
  const double y = at.y();
  values << 0.5 * (1 - x * x) * (1 - y), 0.5 * (1 - y * y) * (1 + x),
      0.5 * (1 - x * x) * (1 + y), 0.5 * (1 - y * y) * (1 - x);
  return values;
}

struct SurfaceFunctions {
  Eigen::VectorXd N;
  Corners d;  // natural slopes, n x 2
};

// Ends of a side lose half of what its middle has.
SurfaceFunctions functions_at(const Surface& s, const Vector2d& at) {
  const auto n = static_cast<Index>(s.grids.size());
  SurfaceFunctions f{Eigen::VectorXd(n), Corners(n, 2)};
  f.N.head(s.corners) = corner_values(s.corners, at);
  f.d.topRows(s.corners) = corner_slopes(s.corners, at);
  const Eigen::VectorXd sides = side_values(s.corners, at);
  const Corners slopes = bubble_slopes(s.corners, at);
  Index next = s.corners;
  for (Index k = 0; k < s.corners; ++k) {
    if (!s.has_mid[static_cast<std::size_t>(k)]) continue;
    for (const Index end : {k, (k + 1) % s.corners}) {
      f.N(end) -= 0.5 * sides(k);
      f.d.row(end) -= 0.5 * slopes.row(k);
    }
    f.N(next) = sides(k);
    f.d.row(next++) = slopes.row(k);
  }
  return f;
}

// Functions of turns: on the quadrilateral one more, (1 - xi^2) (1 - eta^2),
// and the others without their value in the middle.
SurfaceFunctions turn_functions(const Surface& s,
                                const SurfaceFunctions& f,
                                const Vector2d& at) {
  if (s.corners == 3) return f;
  const auto n = static_cast<Index>(s.grids.size());
  const double x = at.x();
  const double y = at.y();
  const double inner = (1 - x * x) * (1 - y * y);
  const Eigen::RowVector2d slope(-2 * x * (1 - y * y), -2 * y * (1 - x * x));
  const Eigen::VectorXd middle = functions_at(s, Vector2d::Zero()).N;
  SurfaceFunctions turns{Eigen::VectorXd(n + 1), Corners(n + 1, 2)};
  turns.N << f.N - inner * middle, inner;
  turns.d << f.d - middle * slope, slope;
  return turns;
}

// A point of the surface.
struct Point {
  Eigen::VectorXd N;
  Corners d;          // slopes along e1 and e2
  Eigen::VectorXd R;  // of turns, that in the middle last
  Corners Rd;
  Eigen::Matrix3d axes;  // columns e1, e2, n
  double area = 0.0;     // of a unit square of natural coordinates
};

Point point_at(const Deck& deck,
               const Shell& shell,
               const Surface& s,
               const Vector2d& at) {
  const SurfaceFunctions f = functions_at(s, at);
  const Eigen::Matrix<double, 2, 3> tangents = f.d.transpose() * s.X;
  const Vector3d normal = tangents.row(0).cross(tangents.row(1)).transpose();
  const Vector3d mean =
      (s.X.row(s.corners == 4 ? 2 : 1) - s.X.row(0))
          .cross(s.X.row(s.corners - 1) - s.X.row(s.corners == 4 ? 1 : 0))
          .transpose();
  const double size = s.X.rowwise().squaredNorm().maxCoeff();
  if (!(normal.norm() > 1e-8 * size) || !(normal.dot(mean) > 0.0)) {
    throw InputError(
        "the element is turned in on itself, or has no area",
        card_place(deck, shell.where, fmt::format("shell {}", shell.id)),
        "Check the order of its grids: corners, then the middles of the sides "
        "from 1-2 on, which must lie near them.");
  }
  Point p;
  p.N = f.N;
  p.area = normal.norm();
  const Vector3d n = normal.normalized();
  const Vector3d side = (s.X.row(1) - s.X.row(0)).transpose();
  const Vector3d x = (side - n * n.dot(side)).normalized();
  p.axes << x, n.cross(x), n;
  const Eigen::Matrix2d J = tangents * p.axes.leftCols<2>();
  const SurfaceFunctions turns = turn_functions(s, f, at);
  p.d = f.d * J.inverse().transpose();
  p.R = turns.N;
  p.Rd = turns.d * J.inverse().transpose();
  return p;
}

// Over six entries of each grid and the three turns in the middle, where there
// is one.
struct Strains {
  MatrixXd membrane;  // 3 rows
  MatrixXd bending;   // 3
  MatrixXd shear;     // 2
  MatrixXd drilling;  // 1
};

Strains strains_at(const Point& p, double offset) {
  const Index n = p.N.size();
  const Index columns = 6 * n + 3 * (p.R.size() - n);
  Strains s{MatrixXd::Zero(3, columns),
            MatrixXd::Zero(3, columns),
            MatrixXd::Zero(2, columns),
            MatrixXd::Zero(1, columns)};
  const Eigen::RowVector3d e1 = p.axes.col(0).transpose();
  const Eigen::RowVector3d e2 = p.axes.col(1).transpose();
  const Eigen::RowVector3d e3 = p.axes.col(2).transpose();
  for (Index i = 0; i < n; ++i) {
    const double a = p.d(i, 0);
    const double b = p.d(i, 1);
    s.membrane.block<3, 3>(0, 6 * i) << a * e1, b * e2, b * e1 + a * e2;
    s.shear.block<2, 3>(0, 6 * i) << a * e3, b * e3;
    s.drilling.block<1, 3>(0, 6 * i) = 0.5 * (b * e1 - a * e2);
  }
  // (theta x n) . e1 = theta . e2, (theta x n) . e2 = -theta . e1.
  for (Index i = 0; i < p.R.size(); ++i) {
    const Index at = i < n ? 6 * i + 3 : 6 * n;
    const double a = p.Rd(i, 0);
    const double b = p.Rd(i, 1);
    s.bending.block<3, 3>(0, at) << a * e2, -b * e1, b * e2 - a * e1;
    s.shear.block<2, 3>(0, at) << p.R(i) * e2, -p.R(i) * e1;
    s.drilling.block<1, 3>(0, at) = p.R(i) * e3;
  }
  // The surface above the grids moves with their turns.
  if (offset != 0.0) s.membrane += offset * s.bending;
  return s;
}

MatrixXd shear_stiffness(const ShellSection& section) {
  // What is stiff in shear is given a compliance that is hardly felt.
  const double least =
      section.shear_compliance.trace() > 0.0
          ? 1e-6 * section.shear_compliance.trace()
          : 1e-3 / std::max(section.membrane(2, 2), section.membrane(0, 0));
  return (section.shear_compliance + least * Eigen::Matrix2d::Identity())
      .inverse();
}

// The four linear triangles of one, each with its first side along the whole's,
// in either sense.
std::vector<Shell> quarters(const Deck& deck, const Shell& shell) {
  const std::vector<int>& g = shell.grids;
  const std::vector<int>& m = shell.mids;
  if (std::ranges::count(m, 0) > 0) {
    throw InputError(
        "a side of the triangle has no grid in its middle",
        card_place(deck, shell.where, fmt::format("shell {}", shell.id)),
        "Name a grid for each of its sides, or for none.");
  }
  std::vector<Shell> parts(4, shell);
  for (Shell& part : parts) part.mids.clear();
  parts[0].grids = {g[0], m[0], m[2]};
  parts[1].grids = {m[0], g[1], m[1]};
  parts[2].grids = {m[2], m[1], g[2]};
  parts[3].grids = {m[1], m[2], m[0]};
  return parts;
}

// Adds matrices of a part at the places of its grids.
void add_matrices(const ElementMatrices& part, ElementMatrices& whole) {
  const auto place = [&](int grid) {
    return 6 * (std::ranges::find(whole.grids, grid) - whole.grids.begin());
  };
  for (std::size_t a = 0; a < part.grids.size(); ++a) {
    for (std::size_t b = 0; b < part.grids.size(); ++b) {
      const auto i = static_cast<Index>(6 * a);
      const auto j = static_cast<Index>(6 * b);
      const Index row = place(part.grids[a]);
      const Index col = place(part.grids[b]);
      whole.K.block<6, 6>(row, col) += part.K.block<6, 6>(i, j);
      whole.M.block<6, 6>(row, col) += part.M.block<6, 6>(i, j);
    }
  }
}

// Membrane and drilling of a surface; the turns in the middle last.
MatrixXd surface_membrane(const Deck& deck,
                          const Shell& shell,
                          const ShellSection& section,
                          const Surface& s,
                          Index columns) {
  const double G = section.membrane(2, 2);
  MatrixXd K = MatrixXd::Zero(columns, columns);
  for (const int order : {2, 3}) {
    const double share = order == 3 ? full : 1.0 - full;
    for (const GaussPoint& point : gauss_points(s.corners, order)) {
      const Point p = point_at(deck, shell, s, point.at);
      const Strains strains = strains_at(p, shell.offset);
      const double dA = point.weight * p.area;
      K += share * dA * strains.membrane.transpose() * section.membrane *
           strains.membrane;
      if (order == 2) continue;
      K += drilling_tie * dA * G * strains.drilling.transpose() *
           strains.drilling;
    }
  }
  return K;
}

// Bending, what couples it to the membrane, and shear.
MatrixXd surface_bending(const Deck& deck,
                         const Shell& shell,
                         const ShellSection& section,
                         const Surface& s,
                         Index columns) {
  MatrixXd K = MatrixXd::Zero(columns, columns);
  if (!(section.bending.trace() > 0.0)) return K;
  const MatrixXd Ds = shear_stiffness(section);
  for (const GaussPoint& point : gauss_points(s.corners, 2)) {
    const Point p = point_at(deck, shell, s, point.at);
    const MatrixXd shear = strains_at(p, shell.offset).shear;
    K += point.weight * p.area * shear.transpose() * Ds * shear;
  }
  for (const GaussPoint& point : gauss_points(s.corners, 3)) {
    const Point p = point_at(deck, shell, s, point.at);
    const Strains strains = strains_at(p, shell.offset);
    const double dA = point.weight * p.area;
    K += dA * strains.bending.transpose() * section.bending * strains.bending;
    if (!section.is_coupled()) continue;
    const MatrixXd cross =
        dA * strains.membrane.transpose() * section.coupling * strains.bending;
    K += cross + cross.transpose();
  }
  return K;
}

// Four linear triangles that bend, and a membrane that is quadratic where it is
// not coupled to bending.
ElementMatrices triangle_matrices(const Deck& deck,
                                  const Shell& shell,
                                  const ShellSection& section) {
  const Surface s = surface_of(deck, shell);
  const auto n = static_cast<Index>(s.grids.size());
  ElementMatrices whole{
      s.grids, MatrixXd::Zero(6 * n, 6 * n), MatrixXd::Zero(6 * n, 6 * n)};
  ShellSection of_parts = section;
  if (!section.is_coupled()) of_parts.membrane.setZero();
  for (const Shell& part : quarters(deck, shell)) {
    add_matrices(shell_matrices(deck, part, of_parts), whole);
  }
  if (!section.is_coupled()) {
    whole.K += surface_membrane(deck, shell, section, s, 6 * n);
  }
  return whole;
}

// Over (x, y, z) of each grid and its turns.
MatrixXd mass(const Deck& deck,
              const Shell& shell,
              const ShellSection& section,
              const Surface& s) {
  const auto n = static_cast<Index>(s.grids.size());
  MatrixXd M = MatrixXd::Zero(6 * n, 6 * n);
  double whole = 0.0;
  for (const GaussPoint& point : gauss_points(s.corners, 4)) {
    const Point p = point_at(deck, shell, s, point.at);
    const double dA = point.weight * p.area;
    whole += dA * section.mass;
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - p.axes.col(2) * p.axes.col(2).transpose();
    // Velocity of the surface: u + offset theta x n.
    Eigen::Matrix3d arm;  // theta x n = arm theta
    const Vector3d z = shell.offset * p.axes.col(2);
    arm << 0.0, z.z(), -z.y(), -z.z(), 0.0, z.x(), z.y(), -z.x(), 0.0;
    Eigen::Matrix<double, 6, 6> density;
    density << section.mass * Eigen::Matrix3d::Identity(), section.mass * arm,
        section.mass * arm.transpose(),
        section.mass * arm.transpose() * arm + section.rotary * across;
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        M.block<6, 6>(6 * i, 6 * j) += dA * p.N(i) * p.N(j) * density;
      }
    }
  }
  if (deck.coupled_mass) return M;
  Eigen::VectorXd share(n);
  for (Index i = 0; i < n; ++i) share(i) = M(6 * i, 6 * i);
  const double scale = share.sum() > 0.0 ? whole / share.sum() : 0.0;
  M.setZero();
  for (Index i = 0; i < n; ++i) {
    M.diagonal().segment<3>(6 * i).setConstant(scale * share(i));
  }
  return M;
}

}  // namespace

ElementMatrices quadratic_matrices(const Deck& deck,
                                   const Shell& shell,
                                   const ShellSection& section) {
  if (shell.grids.size() == 3) return triangle_matrices(deck, shell, section);
  const Surface s = surface_of(deck, shell);
  const auto n = static_cast<Index>(s.grids.size());
  constexpr Index inner_motions = 3;
  MatrixXd K =
      surface_membrane(deck, shell, section, s, 6 * n + inner_motions) +
      surface_bending(deck, shell, section, s, 6 * n + inner_motions);
  // Without stiffness in its plane nothing holds the middle's turn about n.
  const double least = 1e-9 * K.diagonal().tail<inner_motions>().maxCoeff();
  K.diagonal().tail<inner_motions>().array() += least;
  return {s.grids, condensed(K, inner_motions), mass(deck, shell, section, s)};
}

}  // namespace tapfit::structure
