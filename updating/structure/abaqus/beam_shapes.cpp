#include "updating/structure/abaqus/beam_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tapfit::structure {
namespace {

using std::numbers::pi;

std::vector<double> dimensions(const DataLine& line, std::size_t count) {
  std::vector<double> d;
  for (std::size_t k = 0; k < count; ++k) {
    d.push_back(number_in(line, k, "dimension of the section"));
    if (!(d.back() > 0.0)) {
      fail_at(line.place,
              fmt::format("the dimension {:g} is not above zero", d.back()),
              "Correct the section.");
    }
  }
  return d;
}

[[noreturn]] void no_room(const DataLine& line) {
  fail_at(line.place,
          "the walls of the section have no room in it",
          "Correct the dimensions.");
}

// A rectangle of a section: its sides along 1 and 2, its middle.
struct Wall {
  double a, b, x, y;
};

BeamShape of_walls(const std::vector<Wall>& walls) {
  BeamShape s;
  for (const Wall& w : walls) {
    s.area += w.a * w.b;
    s.centroid[0] += w.a * w.b * w.x;
    s.centroid[1] += w.a * w.b * w.y;
  }
  for (double& x : s.centroid) x /= s.area;
  for (const Wall& w : walls) {
    const double x = w.x - s.centroid[0];
    const double y = w.y - s.centroid[1];
    s.I1 += w.a * w.b * (w.a * w.a / 12.0 + x * x);
    s.I2 += w.a * w.b * (w.b * w.b / 12.0 + y * y);
    s.I12 += w.a * w.b * x * y;
    const double thin = std::min(w.a, w.b);
    s.J += std::max(w.a, w.b) * thin * thin * thin / 3.0;
  }
  // Of a symmetric section, rounding.
  constexpr double rounding = 1e-12;
  if (std::abs(s.I12) < rounding * (s.I1 + s.I2)) s.I12 = 0.0;
  for (double& x : s.centroid) {
    if (std::abs(x) < rounding * std::sqrt(s.area)) x = 0.0;
  }
  return s;
}

// J = a b^3 (1/3 - 0.21 b/a (1 - b^4/(12 a^4))), a >= b.
BeamShape rect(const DataLine& line) {
  const std::vector<double> d = dimensions(line, 2);
  BeamShape s = of_walls({{d[0], d[1], 0.0, 0.0}});
  const double a = std::max(d[0], d[1]);
  const double b = std::min(d[0], d[1]);
  const double ratio = b / a;
  s.J = a * b * b * b *
        (1.0 / 3.0 - 0.21 * ratio * (1.0 - std::pow(ratio, 4) / 12.0));
  s.K1 = s.K2 = 0.85;
  s.size = {d[0], d[1]};
  return s;
}

// Abaqus gives the radius, CalculiX both diameters.
BeamShape circ(const DataLine& line) {
  const bool one = line.text(1).empty();
  const std::vector<double> d = dimensions(line, one ? 1 : 2);
  const double a = one ? d[0] : 0.5 * d[0];
  const double b = one ? d[0] : 0.5 * d[1];
  BeamShape s;
  s.area = pi * a * b;
  s.I1 = pi / 4.0 * a * a * a * b;
  s.I2 = pi / 4.0 * a * b * b * b;
  s.J = pi * std::pow(a * b, 3) / (a * a + b * b);
  s.K1 = s.K2 = 0.89;
  s.size = {2.0 * a, 2.0 * b};
  return s;
}

// Outer radius, wall.
BeamShape pipe(const DataLine& line) {
  const std::vector<double> d = dimensions(line, 2);
  const double inner = d[0] - d[1];
  if (inner < 0.0) no_room(line);
  BeamShape s;
  s.area = pi * (d[0] * d[0] - inner * inner);
  s.I1 = s.I2 = pi / 4.0 * (std::pow(d[0], 4) - std::pow(inner, 4));
  s.J = 2.0 * s.I1;
  s.K1 = s.K2 = 0.53;
  s.size = {2.0 * d[0], 2.0 * d[0]};
  return s;
}

// Sides along 1 and 2, walls at +1, +2, -1, -2. J by Bredt, or that of the open
// section where a wall is as thin as nothing.
BeamShape box(const DataLine& line) {
  const std::vector<double> d = dimensions(line, 6);
  const double inner_1 = d[0] - d[2] - d[4];
  const double inner_2 = d[1] - d[3] - d[5];
  if (!(inner_1 > 0.0 && inner_2 > 0.0)) no_room(line);
  const double between = 0.5 * (d[4] - d[2]);
  BeamShape s = of_walls({{d[2], d[1], 0.5 * (d[0] - d[2]), 0.0},
                          {d[4], d[1], -0.5 * (d[0] - d[4]), 0.0},
                          {inner_1, d[3], between, 0.5 * (d[1] - d[3])},
                          {inner_1, d[5], between, -0.5 * (d[1] - d[5])}});
  const double w = d[0] - 0.5 * (d[2] + d[4]);
  const double h = d[1] - 0.5 * (d[3] + d[5]);
  s.J = std::max(
      s.J, 4.0 * w * w * h * h / (h / d[2] + w / d[3] + h / d[4] + w / d[5]));
  s.K1 = s.K2 = 0.44;
  s.size = {d[0], d[1]};
  return s;
}

// The nodes' height, height, flanges below and above (along 1), their
// thicknesses, the web's.
BeamShape i_shape(const DataLine& line) {
  const double from = number_or(line, 0, 0.0, "height of the nodes");
  DataLine rest = line;
  rest.fields.erase(rest.fields.begin());
  const std::vector<double> d = dimensions(rest, 6);
  const double web = d[0] - d[3] - d[4];
  if (!(web > 0.0 && d[5] <= std::min(d[1], d[2]))) no_room(line);
  BeamShape s = of_walls({{d[1], d[3], 0.0, 0.5 * d[3] - from},
                          {d[5], web, 0.0, d[3] + 0.5 * web - from},
                          {d[2], d[4], 0.0, d[0] - 0.5 * d[4] - from}});
  s.K1 = s.K2 = 0.44;
  s.size = {std::max(d[1], d[2]), d[0]};
  return s;
}

// A, I11, I12, I22, J.
BeamShape general(const DataLine& line) {
  BeamShape s;
  s.area = number_in(line, 0, "area");
  s.I2 = number_in(line, 1, "I11");
  s.I12 = number_or(line, 2, 0.0, "I12");
  s.I1 = number_in(line, 3, "I22");
  s.J = number_or(line, 4, 0.0, "J");
  if (!(s.area > 0.0 && s.I1 >= 0.0 && s.I2 >= 0.0 && s.J >= 0.0)) {
    fail_at(line.place,
            "an area or moment of the section is below zero",
            "Correct the section: A, I11, I12, I22, J.");
  }
  return s;
}

}  // namespace

BeamShape beam_shape(const std::string& type, const DataLine& line) {
  if (type.starts_with("RECT")) return rect(line);
  if (type.starts_with("CIRC")) return circ(line);
  if (type == "PIPE" || type == "THICKPIPE") return pipe(line);
  if (type == "BOX") return box(line);
  if (type == "I") return i_shape(line);
  if (type == "GENERAL") return general(line);
  constexpr std::size_t most = 40;
  fail_at(line.place,
          fmt::format("the section {} is not read", type.substr(0, most)),
          "Use RECT, CIRC, PIPE, BOX, I, or *BEAM GENERAL SECTION with A, I11, "
          "I12, I22, J.");
}

}  // namespace tapfit::structure
