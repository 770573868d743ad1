#include "updating/structure/elements/geometric_stiffness.hpp"

#include "updating/structure/elements/shell_section.hpp"
#include "updating/structure/elements/shell_shapes.hpp"

#include <Eigen/Dense>

#include <array>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// [v] with [v] x = v x x.
Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Vector3d grid_place(const Deck& deck, int grid) {
  return deck.grids[deck.grid_index(grid)].position;
}

Vector3d bar_side(const Deck& deck, const Bar& bar) {
  return grid_place(deck, bar.grids[1]) + bar.offsets[1] -
         grid_place(deck, bar.grids[0]) - bar.offsets[0];
}

bool has_pins(const Bar& bar) {
  return !bar.released[0].empty() || !bar.released[1].empty();
}

// Corners in the plane of a shell, from their mean.
Corners in_plane(const Deck& deck, const Shell& shell, const Matrix3d& axes) {
  const auto n = static_cast<Index>(shell.grids.size());
  Eigen::MatrixX3d x(n, 3);
  for (Index i = 0; i < n; ++i) {
    x.row(i) =
        grid_place(deck, shell.grids[static_cast<std::size_t>(i)]).transpose();
  }
  x.rowwise() -= x.colwise().mean().eval();
  return x * axes.leftCols<2>();
}

Matrix3d shell_axes(const Deck& deck, const Shell& shell) {
  std::array<Vector3d, 4> x;
  const std::size_t n = shell.grids.size();
  for (std::size_t i = 0; i < n; ++i)
    x.at(i) = grid_place(deck, shell.grids[i]);
  const Vector3d across = n == 4 ? Vector3d(x[3] - x[1]) : x[2] - x[0];
  const Vector3d along = n == 4 ? Vector3d(x[2] - x[0]) : x[1] - x[0];
  const Vector3d z = along.cross(across).normalized();
  const Vector3d side = x[1] - x[0];
  Matrix3d axes;
  axes.col(0) = (side - z * z.dot(side)).normalized();
  axes.col(1) = z.cross(axes.col(0));
  axes.col(2) = z;
  return axes;
}

// Slopes of the corners' shapes along the plane's axes, n x 2.
Corners slopes_at(const Corners& xy, const Eigen::Vector2d& at) {
  return corner_slopes(xy.rows(), at) * jacobian(xy, at).inverse().transpose();
}

}  // namespace

Vector3d bar_axis(const Deck& deck, const Bar& bar) {
  return bar_side(deck, bar).normalized();
}

Vector3d rod_axis(const Deck& deck, const Rod& rod) {
  return (grid_place(deck, rod.grids[1]) - grid_place(deck, rod.grids[0]))
      .normalized();
}

GeometricMatrix geometric_matrix(const Deck& deck, const Bar& bar) {
  const Vector3d side = bar_side(deck, bar);
  const double L = side.norm();
  const Vector3d a = side / L;
  Eigen::Matrix4d plane;
  if (has_pins(bar)) {
    plane << 1, 0, -1, 0, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0, 0;
    plane /= L;
  } else {
    plane << 36, 3 * L, -36, 3 * L,        //
        3 * L, 4 * L * L, -3 * L, -L * L,  //
        -36, -3 * L, 36, -3 * L,           //
        3 * L, -L * L, -3 * L, 4 * L * L;
    plane /= 30.0 * L;
  }
  // What moves across, and its slope theta x a, of both ends in space.
  const Matrix3d off_axis = Matrix3d::Identity() - a * a.transpose();
  MatrixXd B = MatrixXd::Zero(12, 12);
  for (Index end = 0; end < 2; ++end) {
    const Vector3d& arm = bar.offsets[static_cast<std::size_t>(end)];
    B.block<3, 3>(6 * end, 6 * end) = off_axis;
    B.block<3, 3>(6 * end, 6 * end + 3) = -off_axis * cross_matrix(arm);
    B.block<3, 3>(6 * end + 3, 6 * end + 3) = -cross_matrix(a);
  }
  MatrixXd inner = MatrixXd::Zero(12, 12);
  for (Index i = 0; i < 4; ++i) {
    for (Index j = 0; j < 4; ++j) {
      inner.block<3, 3>(3 * i, 3 * j).diagonal().setConstant(plane(i, j));
    }
  }
  return {{bar.grids[0], bar.grids[1]}, B.transpose() * inner * B};
}

GeometricMatrix geometric_matrix(const Deck& deck, const Rod& rod) {
  const Vector3d side =
      grid_place(deck, rod.grids[1]) - grid_place(deck, rod.grids[0]);
  const double L = side.norm();
  const Matrix3d off_axis =
      Matrix3d::Identity() - side * side.transpose() / (L * L);
  MatrixXd K = MatrixXd::Zero(12, 12);
  for (const Index i : {0, 6}) {
    for (const Index j : {0, 6}) {
      K.block<3, 3>(i, j) = (i == j ? 1.0 : -1.0) / L * off_axis;
    }
  }
  return {{rod.grids[0], rod.grids[1]}, K};
}

GeometricMatrix geometric_matrix(const Deck& deck,
                                 const Shell& shell,
                                 const Matrix3d& N) {
  const Matrix3d axes = shell_axes(deck, shell);
  const Corners xy = in_plane(deck, shell, axes);
  const Eigen::Matrix2d own =
      axes.leftCols<2>().transpose() * N * axes.leftCols<2>();
  const Index n = xy.rows();
  MatrixXd K = MatrixXd::Zero(6 * n, 6 * n);
  for (const GaussPoint& point : gauss_points(n, 2)) {
    const double dA = point.weight * jacobian(xy, point.at).determinant();
    const Corners slopes = slopes_at(xy, point.at);
    const MatrixXd shared = dA * slopes * own * slopes.transpose();
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        K.block<3, 3>(6 * i, 6 * j).diagonal().array() += shared(i, j);
      }
    }
  }
  return {shell.grids, K};
}

ShellPlane shell_plane(const Deck& deck, const Shell& shell) {
  ShellPlane plane;
  plane.axes = shell_axes(deck, shell);
  const Corners xy = in_plane(deck, shell, plane.axes);
  const Index n = xy.rows();
  Corners slopes = Corners::Zero(n, 2);
  for (const GaussPoint& point : gauss_points(n, 2)) {
    const double dA = point.weight * jacobian(xy, point.at).determinant();
    plane.area += dA;
    slopes += dA * slopes_at(xy, point.at);
  }
  plane.slopes = slopes / plane.area * plane.axes.leftCols<2>().transpose();
  if (!deck.shell_properties.at(shell.property).panel) {
    plane.membrane = shell_section(deck, shell).membrane;
  }
  return plane;
}

Matrix3d membrane_force(const ShellPlane& plane, const Eigen::MatrixX3d& u) {
  // d u / d x in the plane's own axes.
  const Matrix3d slope =
      plane.axes.transpose() * (u.transpose() * plane.slopes) * plane.axes;
  const Vector3d strain(slope(0, 0), slope(1, 1), slope(0, 1) + slope(1, 0));
  const Vector3d force = plane.membrane * strain;
  Matrix3d own = Matrix3d::Zero();
  own(0, 0) = force(0);
  own(1, 1) = force(1);
  own(0, 1) = own(1, 0) = force(2);
  return plane.axes * own * plane.axes.transpose();
}

}  // namespace tapfit::structure
