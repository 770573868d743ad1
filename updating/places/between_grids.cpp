#include "updating/places/between_grids.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using structure::Deck;

// An element of two, three or four grids.
using Corners = std::vector<int>;

// A point in an element: each corner's share of a motion along a tangent, and
// of one across it by the corner's own and by its slopes along two directions.
struct Shapes {
  std::vector<double> linear;
  std::vector<double> cubic;
  /// The direction of a slope in space, with its length, and its shares.
  struct Slope {
    std::vector<Vector3d> along;  // one per corner
    std::vector<double> share;
  };
  std::vector<Slope> slopes;
  double off = 0.0;  // distance of the point [m]
};

// How far outside a point may be by rounding, in natural coordinates.
constexpr double rounding = 1e-6;

Vector3d grid_at(const Deck& deck, int id) {
  return deck.grids[deck.grid_index(id)].position;
}

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
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const auto corner = [&x](int c) { return x[static_cast<std::size_t>(c)]; };
    foot += L(i) * corner(i);
    shapes.linear.push_back(L(i));
    shapes.cubic.push_back(L(i) + L(i) * L(i) * (L(j) + L(k)) -
                           L(i) * (L(j) * L(j) + L(k) * L(k)));
    shapes.slopes[0].along.emplace_back(corner(j) - corner(i));
    shapes.slopes[0].share.push_back(L(i) * L(i) * L(j) + bubble);
    shapes.slopes[1].along.emplace_back(corner(k) - corner(i));
    shapes.slopes[1].share.push_back(L(i) * L(i) * L(k) + bubble);
  }
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
  for (std::size_t i = 0; i < 4; ++i) {
    const double u = xi * corner_xi.at(i);
    const double v = eta * corner_eta.at(i);
    const Surface corner = surface_at(x, corner_xi.at(i), corner_eta.at(i));
    shapes.linear.push_back(0.25 * (1.0 + u) * (1.0 + v));
    shapes.cubic.push_back(0.125 * (1.0 + u) * (1.0 + v) *
                           (2.0 + u + v - xi * xi - eta * eta));
    shapes.slopes[0].along.push_back(corner.by_xi);
    shapes.slopes[0].share.push_back(0.125 * corner_xi.at(i) * (1.0 + v) *
                                     (1.0 + u) * (1.0 + u) * (u - 1.0));
    shapes.slopes[1].along.push_back(corner.by_eta);
    shapes.slopes[1].share.push_back(0.125 * corner_eta.at(i) * (1.0 + u) *
                                     (1.0 + v) * (1.0 + v) * (v - 1.0));
  }
  shapes.off = (at - surface_at(x, xi, eta).x).norm();
  return shapes;
}

std::vector<Vector3d> corners_of(const Deck& deck, const Corners& grids) {
  std::vector<Vector3d> x;
  for (const int id : grids) x.push_back(grid_at(deck, id));
  return x;
}

std::optional<Shapes> shapes_on(const std::vector<Vector3d>& x,
                                const Vector3d& at) {
  // Off the element by more than this part of a side it is on another one.
  constexpr double off = 1e-3;
  if ((x[1] - x[0]).squaredNorm() == 0.0) return std::nullopt;
  std::optional<Shapes> shapes;
  if (x.size() == 2) shapes = on_bar(x, at);
  if (x.size() == 3) shapes = on_triangle(x, at);
  if (x.size() == 4) shapes = on_quadrilateral(x, at);
  if (shapes && shapes->off > off * (x[1] - x[0]).norm()) return std::nullopt;
  return shapes;
}

// Elements that a grid is a corner of.
std::vector<Corners> elements_at(const Deck& deck, int node) {
  std::vector<Corners> found;
  for (const structure::Shell& e : deck.shells) {
    if (std::ranges::find(e.grids, node) != e.grids.end()) {
      found.push_back(e.grids);
    }
  }
  for (const structure::Bar& e : deck.bars) {
    if (std::ranges::find(e.grids, node) != e.grids.end()) {
      found.emplace_back(e.grids.begin(), e.grids.end());
    }
  }
  return found;
}

// Grids that share a side with one.
std::set<int> joined_to(const Deck& deck, int node) {
  std::set<int> joined;
  for (const Corners& element : elements_at(deck, node)) {
    const auto n = element.size();
    const auto own = static_cast<std::size_t>(std::ranges::find(element, node) -
                                              element.begin());
    joined.insert(element[(own + 1) % n]);
    joined.insert(element[(own + n - 1) % n]);
  }
  return joined;
}

// Across a bar all directions but its own, across a shell its normal.
Vector3d across(const std::vector<Vector3d>& x, const Vector3d& axis) {
  if (x.size() == 2) {
    const Vector3d t = (x[1] - x[0]).normalized();
    return axis - axis.dot(t) * t;
  }
  const Vector3d normal = x.size() == 3
                              ? (x[1] - x[0]).cross(x[2] - x[0]).normalized()
                              : (x[2] - x[0]).cross(x[3] - x[1]).normalized();
  return axis.dot(normal) * normal;
}

}  // namespace

Vector3d position_of(const Where& where, const Deck& deck) {
  if (where.at.size() != 3) return grid_at(deck, where.node);
  return {where.at[0], where.at[1], where.at[2]};
}

// u . d = sum_k N_k u_k . d + (H_k - N_k) u_k . c + sum_slopes S_k theta_k . (e
// x c), with c the part of d across the element and e the slope's direction:
// turning by theta moves what lies at e by theta x e.
std::vector<MotionShare> motion_between(const Deck& deck,
                                        const Where& where,
                                        int component) {
  const Vector3d at = position_of(where, deck);
  const Vector3d axis = Vector3d::Unit(component - 1);
  std::vector<MotionShare> shares;
  for (const Corners& grids : elements_at(deck, where.node)) {
    const std::vector<Vector3d> x = corners_of(deck, grids);
    const std::optional<Shapes> shapes = shapes_on(x, at);
    if (!shapes) continue;
    const Vector3d c = across(x, axis);
    for (std::size_t k = 0; k < grids.size(); ++k) {
      const Vector3d moved =
          shapes->linear[k] * axis + (shapes->cubic[k] - shapes->linear[k]) * c;
      Vector3d turned = Vector3d::Zero();
      for (const Shapes::Slope& slope : shapes->slopes) {
        turned += slope.share[k] * slope.along[k].cross(c);
      }
      for (int i = 0; i < 3; ++i) {
        if (moved(i) != 0.0) shares.push_back({grids[k], i + 1, moved(i)});
        if (turned(i) != 0.0) shares.push_back({grids[k], i + 4, turned(i)});
      }
    }
    return shares;
  }
  return shares;
}

std::vector<Where> moved_to(const Where& where,
                            const Vector3d& at,
                            const Deck& deck) {
  std::set<int> nodes = joined_to(deck, where.node);
  nodes.insert(where.node);
  Where moved = where;
  moved.at = {at.x(), at.y(), at.z()};
  double least = 1e300;
  for (const int node : nodes) {
    Where tried = moved;
    tried.node = node;
    const double far = (grid_at(deck, node) - at).norm();
    if (far >= least || motion_between(deck, tried, 1).empty()) continue;
    least = far;
    moved = tried;
  }
  if (least == 1e300) return {};
  return {moved};
}

std::vector<Where> places_around(const Where& where,
                                 double step,
                                 const Deck& deck) {
  const Vector3d from = position_of(where, deck);
  const Vector3d node = grid_at(deck, where.node);
  std::vector<Where> places;
  for (const int other : joined_to(deck, where.node)) {
    const Vector3d at = from + step * (grid_at(deck, other) - node);
    const std::vector<Where> found = moved_to(where, at, deck);
    places.insert(places.end(), found.begin(), found.end());
  }
  return places;
}

}  // namespace tapfit::updating
