#include "updating/structure/abaqus/face_shapes.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>

namespace tapfit::structure {
namespace {

// Values in the first column, derivatives in the others.
using Shapes = Eigen::MatrixX3d;

constexpr std::array<double, 4> corner_xi{-1.0, 1.0, 1.0, -1.0};
constexpr std::array<double, 4> corner_eta{-1.0, -1.0, 1.0, 1.0};

Shapes quad4(double xi, double eta) {
  Shapes N(4, 3);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double a = corner_xi.at(static_cast<std::size_t>(i));
    const double b = corner_eta.at(static_cast<std::size_t>(i));
    N.row(i) << 0.25 * (1 + a * xi) * (1 + b * eta), 0.25 * a * (1 + b * eta),
        0.25 * b * (1 + a * xi);
  }
  return N;
}

// Serendipity: the corners less half of both neighbours.
Shapes quad8(double xi, double eta) {
  Shapes N(8, 3);
  const auto middle_x = [&](double b) {
    return Eigen::RowVector3d(0.5 * (1 - xi * xi) * (1 + b * eta),
                              -xi * (1 + b * eta),
                              0.5 * b * (1 - xi * xi));
  };
  const auto middle_y = [&](double a) {
    return Eigen::RowVector3d(0.5 * (1 + a * xi) * (1 - eta * eta),
                              0.5 * a * (1 - eta * eta),
                              -eta * (1 + a * xi));
  };
  N.topRows<4>() = quad4(xi, eta);
  N.row(4) = middle_x(-1.0);
  N.row(5) = middle_y(1.0);
  N.row(6) = middle_x(1.0);
  N.row(7) = middle_y(-1.0);
  for (Eigen::Index i = 0; i < 4; ++i) {
    N.row(i) -= 0.5 * (N.row(4 + i) + N.row(4 + (i + 3) % 4));
  }
  return N;
}

Shapes triangle3(double xi, double eta) {
  Shapes N(3, 3);
  N << 1 - xi - eta, -1, -1, xi, 1, 0, eta, 0, 1;
  return N;
}

Shapes triangle6(double xi, double eta) {
  const Shapes L = triangle3(xi, eta);
  Shapes N(6, 3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index j = (i + 1) % 3;
    N.row(i) = (4 * L(i, 0) - 1) * L.row(i);
    N(i, 0) = L(i, 0) * (2 * L(i, 0) - 1);
    N.row(3 + i) = 4 * (L(j, 0) * L.row(i) + L(i, 0) * L.row(j));
    N(3 + i, 0) = 4 * L(i, 0) * L(j, 0);
  }
  return N;
}

Shapes shapes_at(std::size_t nodes, double xi, double eta) {
  switch (nodes) {
    case 3:
      return triangle3(xi, eta);
    case 4:
      return quad4(xi, eta);
    case 6:
      return triangle6(xi, eta);
    default:
      return quad8(xi, eta);
  }
}

}  // namespace

std::optional<OnFace> place_on_face(const std::vector<Eigen::Vector3d>& nodes,
                                    const Eigen::Vector3d& p) {
  const bool triangle = nodes.size() == 3 || nodes.size() == 6;
  const auto n = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixX3d X(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    X.row(i) = nodes[static_cast<std::size_t>(i)].transpose();
  }
  Eigen::Vector2d at = Eigen::Vector2d::Constant(triangle ? 1.0 / 3.0 : 0.0);
  constexpr int most_steps = 25;
  constexpr double fine = 1e-10;
  for (int step = 0; step < most_steps; ++step) {
    const Shapes N = shapes_at(nodes.size(), at.x(), at.y());
    const Eigen::Vector3d off = p - X.transpose() * N.col(0);
    const Eigen::Matrix<double, 3, 2> T = X.transpose() * N.rightCols<2>();
    const Eigen::Vector2d move = T.colPivHouseholderQr().solve(off);
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
  found.shares = shapes_at(nodes.size(), at.x(), at.y()).col(0);
  found.distance = (p - X.transpose() * found.shares).norm();
  return found;
}

}  // namespace tapfit::structure
