#include "updating/structure/elements/shell_shapes.hpp"

#include <Eigen/Dense>

#include <array>
#include <cassert>
#include <cmath>

namespace tapfit::structure {
namespace {

struct LinePoint {
  double at;
  double weight;
};

std::vector<LinePoint> line_rule(int order) {
  const double a = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(1.2));
  const double b = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(1.2));
  const double wa = (18.0 + std::sqrt(30.0)) / 36.0;
  const double wb = (18.0 - std::sqrt(30.0)) / 36.0;
  const double g2 = std::sqrt(1.0 / 3.0);
  const double g3 = std::sqrt(0.6);
  switch (order) {
    case 1:
      return {{0.0, 2.0}};
    case 2:
      return {{-g2, 1.0}, {g2, 1.0}};
    case 3:
      return {{-g3, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {g3, 5.0 / 9.0}};
    default:
      assert(order == 4);
      return {{-b, wb}, {-a, wa}, {a, wa}, {b, wb}};
  }
}

constexpr std::array<double, 4> xi{-1.0, 1.0, 1.0, -1.0};
constexpr std::array<double, 4> eta{-1.0, -1.0, 1.0, 1.0};

Eigen::Vector3d area_coordinates(const Eigen::Vector2d& at) {
  return {1.0 - at.x() - at.y(), at.x(), at.y()};
}

Corners area_slopes() {
  Corners d(3, 2);
  d << -1.0, -1.0, 1.0, 0.0, 0.0, 1.0;
  return d;
}

// Values for w, w_xi, w_eta of corner i.
Eigen::Vector3d adini(std::size_t i, const Eigen::Vector2d& at) {
  const double x = at.x() * xi[i];
  const double y = at.y() * eta[i];
  return Eigen::Vector3d((1 + x) * (1 + y) * (2 + x + y - x * x - y * y),
                         xi[i] * (1 + x) * (1 + x) * (x - 1) * (1 + y),
                         eta[i] * (1 + y) * (1 + y) * (y - 1) * (1 + x)) /
         8.0;
}

Eigen::VectorXd quad_deflection(const Corners& xy, const Eigen::Vector2d& at) {
  Eigen::VectorXd values(12);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Eigen::Matrix2d J = jacobian(xy, {xi[k], eta[k]});
    const Eigen::Vector3d N = adini(k, at);
    values(3 * i) = N(0);
    values.segment<2>(3 * i + 1) = J.transpose() * N.tail<2>();
  }
  return values;
}

Eigen::VectorXd triangle_deflection(const Corners& xy,
                                    const Eigen::Vector2d& at) {
  const Eigen::Vector3d L = area_coordinates(at);
  const double bubble = 0.5 * L.prod();
  Eigen::VectorXd values(9);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index j = (i + 1) % 3;
    const Eigen::Index k = (i + 2) % 3;
    values(3 * i) =
        L(i) + L(i) * L(i) * (L(j) + L(k)) - L(i) * (L(j) * L(j) + L(k) * L(k));
    const Eigen::RowVector2d slope =
        (xy.row(j) - xy.row(i)) * (L(i) * L(i) * L(j) + bubble) +
        (xy.row(k) - xy.row(i)) * (L(i) * L(i) * L(k) + bubble);
    values.segment<2>(3 * i + 1) = slope.transpose();
  }
  return values;
}

}  // namespace

std::vector<GaussPoint> gauss_points(Eigen::Index corners, int order) {
  std::vector<GaussPoint> points;
  for (const LinePoint& p : line_rule(order)) {
    for (const LinePoint& q : line_rule(order)) {
      if (corners == 4) {
        points.push_back({{p.at, q.at}, p.weight * q.weight});
      } else {
        const double u = 0.5 * (1.0 + p.at);
        const double v = 0.5 * (1.0 + q.at) * (1.0 - u);
        points.push_back({{u, v}, 0.25 * (1.0 - u) * p.weight * q.weight});
      }
    }
  }
  return points;
}

std::vector<GaussPoint> line_points(int order) {
  std::vector<GaussPoint> points;
  for (const LinePoint& p : line_rule(order)) {
    points.push_back({{p.at, 0.0}, p.weight});
  }
  return points;
}

Eigen::VectorXd corner_values(Eigen::Index corners, const Eigen::Vector2d& at) {
  if (corners == 3) return area_coordinates(at);
  Eigen::Vector4d N;
  for (std::size_t i = 0; i < 4; ++i) {
    N(static_cast<Eigen::Index>(i)) =
        0.25 * (1.0 + at.x() * xi[i]) * (1.0 + at.y() * eta[i]);
  }
  return N;
}

Corners corner_slopes(Eigen::Index corners, const Eigen::Vector2d& at) {
  if (corners == 3) return area_slopes();
  Corners d(4, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    d.row(static_cast<Eigen::Index>(i))
        << 0.25 * xi[i] * (1.0 + at.y() * eta[i]),
        0.25 * eta[i] * (1.0 + at.x() * xi[i]);
  }
  return d;
}

Corners bubble_slopes(Eigen::Index corners, const Eigen::Vector2d& at) {
  if (corners == 3) {
    const Eigen::Vector3d L = area_coordinates(at);
    const Corners dL = area_slopes();
    Corners d(3, 2);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Index j = (i + 1) % 3;
      d.row(i) = 4.0 * (L(i) * dL.row(j) + L(j) * dL.row(i));
    }
    return d;
  }
  const double x = at.x();
  const double y = at.y();
  Corners d(4, 2);
  d << -x * (1 - y), -0.5 * (1 - x * x),  //
      0.5 * (1 - y * y), -y * (1 + x),    //
      -x * (1 + y), 0.5 * (1 - x * x),    //
      -0.5 * (1 - y * y), -y * (1 - x);
  return d;
}

Corners side_fields(Eigen::Index corners, const Eigen::Vector2d& at) {
  if (corners == 3) {
    const Eigen::Vector3d L = area_coordinates(at);
    const Corners dL = area_slopes();
    Corners field(3, 2);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Index j = (i + 1) % 3;
      field.row(i) = L(i) * dL.row(j) - L(j) * dL.row(i);
    }
    return field;
  }
  Corners field(4, 2);
  field << 0.25 * (1 - at.y()), 0.0,  //
      0.0, 0.25 * (1 + at.x()),       //
      -0.25 * (1 + at.y()), 0.0,      //
      0.0, -0.25 * (1 - at.x());
  return field;
}

Eigen::Matrix2d jacobian(const Corners& xy, const Eigen::Vector2d& at) {
  return corner_slopes(xy.rows(), at).transpose() * xy;
}

Eigen::VectorXd deflection_values(const Corners& xy,
                                  const Eigen::Vector2d& at) {
  return xy.rows() == 3 ? triangle_deflection(xy, at) : quad_deflection(xy, at);
}

}  // namespace tapfit::structure
