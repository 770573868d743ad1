#include "updating/places/element_shapes.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// How far outside a point may be by rounding, in natural coordinates.
constexpr double rounding = 1e-6;

std::optional<Shapes> on_bar(const std::vector<Vector3d>& x,
                             const Vector3d& at) {
  const Vector3d along = x[1] - x[0];
  const double s = (at - x[0]).dot(along) / along.squaredNorm();
  if (s < -rounding || s > 1.0 + rounding) return std::nullopt;
  Shapes shapes;
  shapes.linear = {1.0 - s, s};
  shapes.cubic = {1.0 - s * s * (3.0 - 2.0 * s), s * s * (3.0 - 2.0 * s)};
  shapes.slopes = {
      {{along, along}, {s * (1.0 - s) * (1.0 - s), -s * s * (1.0 - s)}}};
  const Vector3d slope = along / along.squaredNorm();
  shapes.gradient = {-slope, slope};
  shapes.off = (at - x[0] - s * along).norm();
  return shapes;
}

// Area coordinates of the foot of a point on a triangle's plane.
std::optional<Vector3d> area_coordinates(const std::vector<Vector3d>& x,
                                         const Vector3d& at) {
  const Vector3d normal = (x[1] - x[0]).cross(x[2] - x[0]);
  const double area = normal.squaredNorm();
  if (area == 0.0) return std::nullopt;
  Vector3d L;
  for (int i = 0; i < 3; ++i) {
    const Vector3d& b = x[static_cast<std::size_t>((i + 1) % 3)];
    const Vector3d& c = x[static_cast<std::size_t>((i + 2) % 3)];
    L(i) = (b - at).cross(c - at).dot(normal) / area;
  }
  if (L.minCoeff() < -rounding) return std::nullopt;
  return L;
}

std::optional<Shapes> on_triangle(const std::vector<Vector3d>& x,
                                  const Vector3d& at) {
  const std::optional<Vector3d> found = area_coordinates(x, at);
  if (!found) return std::nullopt;
  const Vector3d& L = *found;
  const double bubble = 0.5 * L(0) * L(1) * L(2);
  Shapes shapes;
  shapes.slopes.resize(2);
  Vector3d foot = Vector3d::Zero();
  const Vector3d normal = (x[1] - x[0]).cross(x[2] - x[0]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const auto corner = [&x](int c) { return x[static_cast<std::size_t>(c)]; };
    foot += L(i) * corner(i);
    shapes.gradient.emplace_back(normal.cross(corner(k) - corner(j)) /
                                 normal.squaredNorm());
    shapes.linear.push_back(L(i));
    shapes.cubic.push_back(L(i) + L(i) * L(i) * (L(j) + L(k)) -
                           L(i) * (L(j) * L(j) + L(k) * L(k)));
    shapes.slopes[0].along.emplace_back(corner(j) - corner(i));
    shapes.slopes[0].share.push_back(L(i) * L(i) * L(j) + bubble);
    shapes.slopes[1].along.emplace_back(corner(k) - corner(i));
    shapes.slopes[1].share.push_back(L(i) * L(i) * L(k) + bubble);
  }
  shapes.normal = normal.normalized();
  shapes.off = (at - foot).norm();
  return shapes;
}

constexpr std::array<double, 4> corner_xi = {-1.0, 1.0, 1.0, -1.0};
constexpr std::array<double, 4> corner_eta = {-1.0, -1.0, 1.0, 1.0};

// x(xi, eta) of a quadrilateral and its derivatives.
struct Surface {
  Vector3d x = Vector3d::Zero();
  Vector3d by_xi = Vector3d::Zero();
  Vector3d by_eta = Vector3d::Zero();
};

Surface surface_at(const std::vector<Vector3d>& x, double xi, double eta) {
  Surface at;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = 1.0 + xi * corner_xi.at(i);
    const double b = 1.0 + eta * corner_eta.at(i);
    at.x += 0.25 * a * b * x[i];
    at.by_xi += 0.25 * corner_xi.at(i) * b * x[i];
    at.by_eta += 0.25 * corner_eta.at(i) * a * x[i];
  }
  return at;
}

// (xi, eta) of the foot of a point, by Gauss-Newton steps.
std::optional<Vector2d> natural_coordinates(const std::vector<Vector3d>& x,
                                            const Vector3d& at) {
  constexpr int most_steps = 20;
  Vector2d q = Vector2d::Zero();
  for (int step = 0; step < most_steps; ++step) {
    const Surface s = surface_at(x, q(0), q(1));
    Matrix2d A;
    A << s.by_xi.dot(s.by_xi), s.by_xi.dot(s.by_eta), s.by_xi.dot(s.by_eta),
        s.by_eta.dot(s.by_eta);
    const Vector2d b((at - s.x).dot(s.by_xi), (at - s.x).dot(s.by_eta));
    const Vector2d change = A.fullPivLu().solve(b);
    q += change;
    if (!q.allFinite() || q.cwiseAbs().maxCoeff() > 3.0) return std::nullopt;
    if (change.norm() < 1e-12) break;
  }
  if (q.cwiseAbs().maxCoeff() > 1.0 + rounding) return std::nullopt;
  return q;
}

std::optional<Shapes> on_quadrilateral(const std::vector<Vector3d>& x,
                                       const Vector3d& at) {
  const std::optional<Vector2d> q = natural_coordinates(x, at);
  if (!q) return std::nullopt;
  const double xi = (*q)(0);
  const double eta = (*q)(1);
  Shapes shapes;
  shapes.slopes.resize(2);
  const Surface here = surface_at(x, xi, eta);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << here.by_xi, here.by_eta;
  const Eigen::Matrix<double, 3, 2> to_space =
      tangents * Matrix2d(tangents.transpose() * tangents).inverse();
  for (std::size_t i = 0; i < 4; ++i) {
    const double u = xi * corner_xi.at(i);
    const double v = eta * corner_eta.at(i);
    const Surface corner = surface_at(x, corner_xi.at(i), corner_eta.at(i));
    shapes.linear.push_back(0.25 * (1.0 + u) * (1.0 + v));
    shapes.gradient.emplace_back(to_space *
                                 Vector2d(0.25 * corner_xi.at(i) * (1.0 + v),
                                          0.25 * corner_eta.at(i) * (1.0 + u)));
    shapes.cubic.push_back(0.125 * (1.0 + u) * (1.0 + v) *
                           (2.0 + u + v - xi * xi - eta * eta));
    shapes.slopes[0].along.push_back(corner.by_xi);
    shapes.slopes[0].share.push_back(0.125 * corner_xi.at(i) * (1.0 + v) *
                                     (1.0 + u) * (1.0 + u) * (u - 1.0));
    shapes.slopes[1].along.push_back(corner.by_eta);
    shapes.slopes[1].share.push_back(0.125 * corner_eta.at(i) * (1.0 + u) *
                                     (1.0 + v) * (1.0 + v) * (v - 1.0));
  }
  shapes.normal = here.by_xi.cross(here.by_eta).normalized();
  shapes.off = (at - here.x).norm();
  return shapes;
}

Vector3d nearest_on_side(const Vector3d& a,
                         const Vector3d& b,
                         const Vector3d& at) {
  const Vector3d along = b - a;
  const double length = along.squaredNorm();
  const double s = length > 0.0 ? (at - a).dot(along) / length : 0.0;
  return a + std::clamp(s, 0.0, 1.0) * along;
}

Vector3d foot_in(const std::vector<Vector3d>& x, const Shapes& shapes) {
  Vector3d foot = Vector3d::Zero();
  for (std::size_t k = 0; k < x.size(); ++k) foot += shapes.linear[k] * x[k];
  return foot;
}

}  // namespace

std::optional<Shapes> shapes_at(const std::vector<Vector3d>& x,
                                const Vector3d& at) {
  if ((x[1] - x[0]).squaredNorm() == 0.0) return std::nullopt;
  if (x.size() == 2) return on_bar(x, at);
  if (x.size() == 3) return on_triangle(x, at);
  return on_quadrilateral(x, at);
}

Vector3d normal_of(const std::vector<Vector3d>& x) {
  return x.size() == 3 ? (x[1] - x[0]).cross(x[2] - x[0]).normalized()
                       : (x[2] - x[0]).cross(x[3] - x[1]).normalized();
}

Vector3d across(const std::vector<Vector3d>& x, const Vector3d& axis) {
  if (x.size() == 2) {
    const Vector3d t = (x[1] - x[0]).normalized();
    return axis - axis.dot(t) * t;
  }
  const Vector3d normal = normal_of(x);
  return axis.dot(normal) * normal;
}

// u . d = sum_k N_k u_k . d + (H_k - N_k) u_k . c + sum_slopes S_k theta_k . (e
// x c), with c the part of d across the element and e the slope's direction:
// turning by theta moves what lies at e by theta x e.
std::vector<CornerMotion> motion_along(const std::vector<Vector3d>& x,
                                       const Shapes& shapes,
                                       const Vector3d& axis) {
  const Vector3d c = across(x, axis);
  std::vector<CornerMotion> corners(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    corners[k].moved =
        shapes.linear[k] * axis + (shapes.cubic[k] - shapes.linear[k]) * c;
    for (const Shapes::Slope& slope : shapes.slopes) {
      corners[k].turned += slope.share[k] * slope.along[k].cross(c);
    }
  }
  return corners;
}

Vector3d nearest_in(const std::vector<Vector3d>& x, const Vector3d& at) {
  if (x.size() == 2) return nearest_on_side(x[0], x[1], at);
  if (const auto inside = shapes_at(x, at)) return foot_in(x, *inside);
  Vector3d nearest = x[0];
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Vector3d tried = nearest_on_side(x[k], x[(k + 1) % x.size()], at);
    if ((tried - at).norm() < (nearest - at).norm()) nearest = tried;
  }
  return nearest;
}

}  // namespace tapfit::updating
