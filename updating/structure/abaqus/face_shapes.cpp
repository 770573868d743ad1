#include "updating/structure/abaqus/face_shapes.hpp"

#include <Eigen/Dense>

namespace tapfit::structure {
namespace {

using Eigen::Vector2d;

// Functions of the corners, then of the middles of the sides; with a middle on
// each side corners lose half of both neighbours.
Eigen::VectorXd shapes_at(Eigen::Index nodes, const Vector2d& at) {
  const bool triangle = nodes % 3 == 0;
  const Eigen::Index corners = triangle ? 3 : 4;
  const double x = at.x();
  const double y = at.y();
  Eigen::VectorXd N(nodes);
  if (triangle) {
    N.head<3>() << 1 - x - y, x, y;
  } else {
    N.head<4>() << (1 - x) * (1 - y), (1 + x) * (1 - y), (1 + x) * (1 + y),
        (1 - x) * (1 + y);
    N.head<4>() /= 4;
  }
  if (nodes == corners) return N;
  if (triangle) {
    N.tail<3>() << 4 * N(0) * N(1), 4 * N(1) * N(2), 4 * N(2) * N(0);
  } else {
    N.tail<4>() << (1 - x * x) * (1 - y), (1 + x) * (1 - y * y),
        (1 - x * x) * (1 + y), (1 - x) * (1 - y * y);
    N.tail<4>() /= 2;
  }
  for (Eigen::Index i = 0; i < corners; ++i) {
    N(i) -= (N(corners + i) + N(corners + (i + corners - 1) % corners)) / 2;
  }
  return N;
}

// Functions are quadratic along each coordinate, of which central differences
// are the slope.
Eigen::MatrixX2d slopes_at(Eigen::Index nodes, const Vector2d& at) {
  Eigen::MatrixX2d slopes(nodes, 2);
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Vector2d half = 0.5 * Vector2d::Unit(k);
    slopes.col(k) = shapes_at(nodes, at + half) - shapes_at(nodes, at - half);
  }
  return slopes;
}

}  // namespace

std::optional<OnFace> place_on_face(const std::vector<Eigen::Vector3d>& nodes,
                                    const Eigen::Vector3d& p) {
  const auto n = static_cast<Eigen::Index>(nodes.size());
  const bool triangle = n % 3 == 0;
  Eigen::Matrix3Xd X(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    X.col(i) = nodes[static_cast<std::size_t>(i)];
  }
  Vector2d at = Vector2d::Constant(triangle ? 1.0 / 3.0 : 0.0);
  constexpr int most_steps = 25;
  constexpr double fine = 1e-10;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::Vector3d off = p - X * shapes_at(n, at);
    const Eigen::Matrix<double, 3, 2> T = X * slopes_at(n, at);
    const Vector2d move = T.colPivHouseholderQr().solve(off);
    if (!move.allFinite()) return {};
    // Far outside the face shape functions mean nothing.
    at = (at + move).cwiseMax(-3.0).cwiseMin(3.0);
    if (move.norm() < fine) break;
  }
  constexpr double beside = 1e-3;  // of the face's half side, for rounding
  const bool inside = triangle
                          ? at.minCoeff() > -beside && at.sum() < 1.0 + beside
                          : at.cwiseAbs().maxCoeff() < 1.0 + beside;
  if (!inside) return {};
  OnFace found;
  found.shares = shapes_at(n, at);
  found.distance = (p - X * found.shares).norm();
  return found;
}

}  // namespace tapfit::structure
