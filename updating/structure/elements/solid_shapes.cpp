#include "updating/structure/elements/solid_shapes.hpp"

#include "updating/structure/elements/shell_shapes.hpp"

namespace tapfit::structure {
namespace {

using Eigen::Vector3d;

// A value with its slopes, so that a function is written once.
struct Sloped {
  double value = 0.0;
  Vector3d slope = Vector3d::Zero();
};

Sloped operator+(const Sloped& a, const Sloped& b) {
  return {a.value + b.value, a.slope + b.slope};
}
Sloped operator-(const Sloped& a, const Sloped& b) {
  return {a.value - b.value, a.slope - b.slope};
}
Sloped operator*(const Sloped& a, const Sloped& b) {
  return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}
Sloped operator/(const Sloped& a, const Sloped& b) {
  const double q = a.value / b.value;
  return {q, (a.slope - q * b.slope) / b.value};
}
Sloped operator+(double a, const Sloped& b) { return {a + b.value, b.slope}; }
Sloped operator-(double a, const Sloped& b) { return {a - b.value, -b.slope}; }
Sloped operator*(double a, const Sloped& b) {
  return {a * b.value, a * b.slope};
}

struct Coordinates {
  Sloped x, y, z;
};

Coordinates coordinates(const Vector3d& at) {
  return {{at.x(), Vector3d::UnitX()},
          {at.y(), Vector3d::UnitY()},
          {at.z(), Vector3d::UnitZ()}};
}

using Functions = std::vector<Sloped>;

constexpr std::array<std::array<int, 3>, 8> hexa{{{-1, -1, -1},
                                                  {1, -1, -1},
                                                  {1, 1, -1},
                                                  {-1, 1, -1},
                                                  {-1, -1, 1},
                                                  {1, -1, 1},
                                                  {1, 1, 1},
                                                  {-1, 1, 1}}};

Sloped hexa_factor(int sign, const Sloped& x) {
  return sign == 0 ? 1.0 - x * x : 0.5 * (1.0 + static_cast<double>(sign) * x);
}

Functions hexa_corners(const Coordinates& c) {
  Functions f;
  for (const auto& [i, j, k] : hexa) {
    f.push_back(hexa_factor(i, c.x) * hexa_factor(j, c.y) *
                hexa_factor(k, c.z));
  }
  return f;
}

std::array<Sloped, 3> area_coordinates(const Coordinates& c) {
  return {1.0 - c.x - c.y, c.x, c.y};
}

std::array<Sloped, 4> volume_coordinates(const Coordinates& c) {
  return {1.0 - c.x - c.y - c.z, c.x, c.y, c.z};
}

Functions wedge_corners(const Coordinates& c) {
  Functions f;
  for (const int side : {-1, 1}) {
    for (const Sloped& L : area_coordinates(c)) {
      f.push_back(L * hexa_factor(side, c.z));
    }
  }
  return f;
}

Functions pyramid_corners(const Coordinates& c) {
  Functions f;
  const Sloped to_apex = 1.0 - c.z;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = hexa.at(i)[0];
    const double b = hexa.at(i)[1];
    f.push_back(0.25 * ((1.0 + a * c.x) * (1.0 + b * c.y) - c.z +
                        (a * b) * (c.x * c.y * c.z / to_apex)));
  }
  f.push_back(c.z);
  return f;
}

Functions corner_functions(std::size_t corners, const Coordinates& c) {
  switch (corners) {
    case 8:
      return hexa_corners(c);
    case 6:
      return wedge_corners(c);
    case 5:
      return pyramid_corners(c);
    default:
      const std::array<Sloped, 4> L = volume_coordinates(c);
      return {L.begin(), L.end()};
  }
}

Sloped pyramid_edge(const std::array<int, 2>& edge, const Coordinates& c) {
  const Sloped to_apex = 1.0 - c.z;
  const auto first = static_cast<std::size_t>(edge[0]);
  const double a = hexa.at(first)[0];
  const double b = hexa.at(first)[1];
  if (edge[1] == 4) {
    return c.z * (to_apex + a * c.x) * (to_apex + b * c.y) / to_apex;
  }
  const auto second = static_cast<std::size_t>(edge[1]);
  const bool along_x = hexa.at(second)[0] != hexa.at(first)[0];
  const Sloped& along = along_x ? c.x : c.y;
  const Sloped across = along_x ? b * c.y : a * c.x;
  return 0.5 *
         ((to_apex + along) * (to_apex - along) * (to_apex + across) / to_apex);
}

Sloped edge_function(std::size_t corners,
                     const std::array<int, 2>& edge,
                     const Coordinates& c) {
  const auto i = static_cast<std::size_t>(edge[0]);
  const auto j = static_cast<std::size_t>(edge[1]);
  if (corners == 8) {
    const auto factor = [&](std::size_t axis, const Sloped& x) {
      const int a = hexa.at(i).at(axis);
      return hexa_factor(a == hexa.at(j).at(axis) ? a : 0, x);
    };
    return factor(0, c.x) * factor(1, c.y) * factor(2, c.z);
  }
  if (corners == 6) {
    const std::array<Sloped, 3> L = area_coordinates(c);
    if (i + 3 == j) return L.at(i) * (1.0 - c.z * c.z);
    return 4.0 * (L.at(i % 3) * L.at(j % 3) * hexa_factor(i < 3 ? -1 : 1, c.z));
  }
  if (corners == 5) return pyramid_edge(edge, c);
  const std::array<Sloped, 4> L = volume_coordinates(c);
  return 4.0 * (L.at(i) * L.at(j));
}

// A square's or a triangle's points drawn together towards the apex.
std::vector<SolidPoint> collapsed_points(Eigen::Index base_corners, int order) {
  std::vector<SolidPoint> points;
  for (const GaussPoint& base : gauss_points(base_corners, order)) {
    for (const GaussPoint& up : line_points(order)) {
      const double z = 0.5 * (1.0 + up.at.x());
      const double narrow = 1.0 - z;
      points.push_back({{base.at.x() * narrow, base.at.y() * narrow, z},
                        0.5 * up.weight * base.weight * narrow * narrow});
    }
  }
  return points;
}

}  // namespace

const std::vector<std::array<int, 2>>& solid_edges(std::size_t corners) {
  using Edges = std::vector<std::array<int, 2>>;
  static const Edges hexa_edges{{0, 1},
                                {1, 2},
                                {2, 3},
                                {3, 0},
                                {0, 4},
                                {1, 5},
                                {2, 6},
                                {3, 7},
                                {4, 5},
                                {5, 6},
                                {6, 7},
                                {7, 4}};
  static const Edges wedge_edges{
      {0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {5, 3}};
  static const Edges pyramid_edges{
      {0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  static const Edges tetra_edges{
      {0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  switch (corners) {
    case 8:
      return hexa_edges;
    case 6:
      return wedge_edges;
    case 5:
      return pyramid_edges;
    default:
      return tetra_edges;
  }
}

std::vector<SolidPoint> solid_points(std::size_t corners, int order) {
  if (corners == 5) return collapsed_points(4, order);
  if (corners == 4) return collapsed_points(3, order);
  std::vector<SolidPoint> points;
  for (const GaussPoint& base : gauss_points(corners == 8 ? 4 : 3, order)) {
    for (const GaussPoint& up : line_points(order)) {
      points.push_back(
          {{base.at.x(), base.at.y(), up.at.x()}, base.weight * up.weight});
    }
  }
  return points;
}

SolidFunctions solid_functions(std::size_t corners,
                               const std::vector<bool>& has_mid,
                               const Vector3d& at) {
  const Coordinates c = coordinates(at);
  Functions f = corner_functions(corners, c);
  const auto& edges = solid_edges(corners);
  for (std::size_t k = 0; k < has_mid.size(); ++k) {
    if (!has_mid[k]) continue;
    const Sloped mid = edge_function(corners, edges[k], c);
    for (const int end : edges[k]) {
      Sloped& corner = f[static_cast<std::size_t>(end)];
      corner = corner - 0.5 * mid;
    }
    f.push_back(mid);
  }
  const auto n = static_cast<Eigen::Index>(f.size());
  SolidFunctions result{Eigen::VectorXd(n), Eigen::MatrixX3d(n, 3)};
  for (Eigen::Index i = 0; i < n; ++i) {
    result.values(i) = f[static_cast<std::size_t>(i)].value;
    result.slopes.row(i) = f[static_cast<std::size_t>(i)].slope.transpose();
  }
  return result;
}

Eigen::MatrixX3d inner_mode_slopes(std::size_t corners, const Vector3d& at) {
  if (corners == 8) return (-2.0 * at).asDiagonal().toDenseMatrix();
  if (corners != 6) return Eigen::MatrixX3d(0, 3);
  const std::array<Sloped, 3> L = area_coordinates(coordinates(at));
  Eigen::MatrixX3d slopes(4, 3);
  slopes.row(0) << 0.0, 0.0, -2.0 * at.z();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    slopes.row(k + 1) = (L.at(i) * L.at((i + 1) % 3)).slope.transpose();
  }
  return slopes;
}

}  // namespace tapfit::structure
