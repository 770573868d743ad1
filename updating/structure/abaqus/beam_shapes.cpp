#include "updating/structure/abaqus/beam_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

using std::numbers::pi;

std::vector<double> dimensions(const DataLine& line,
                               std::size_t first,
                               std::size_t count) {
  std::vector<double> d;
  for (std::size_t k = first; k < first + count; ++k) {
    d.push_back(number_in(line, k, "dimension of the section"));
  }
  return d;
}

BeamShape rect(const DataLine& line) {
  const std::vector<double> d = dimensions(line, 0, 2);
  return {.type = "BAR", .numbers = {d[1], d[0]}, .size = {d[0], d[1]}};
}

// Abaqus gives the radius, CalculiX both diameters; of an ellipse
// J = pi a^3 b^3 / (a^2 + b^2).
BeamShape circ(const DataLine& line) {
  const bool one = line.text(1).empty();
  const std::vector<double> d = dimensions(line, 0, one ? 1 : 2);
  const double a = one ? d[0] : 0.5 * d[0];
  const double b = one ? d[0] : 0.5 * d[1];
  BeamShape shape{.type = "ROD", .numbers = {a}, .size = {2.0 * a, 2.0 * b}};
  if (a != b) {
    const double area = pi * a * b;
    shape.type = "";
    shape.numbers = {area,
                     area * a * a / 4.0,
                     area * b * b / 4.0,
                     0.0,
                     area * a * a * b * b / (a * a + b * b)};
  }
  return shape;
}

// Outer radius, wall.
BeamShape pipe(const DataLine& line) {
  const std::vector<double> d = dimensions(line, 0, 2);
  return {.type = "TUBE2",
          .numbers = {d[0], d[1]},
          .size = {2.0 * d[0], 2.0 * d[0]}};
}

// Sides along 1 and 2, walls at +1, +2, -1, -2. The axis lies in the centroid,
// the nodes in the middle of the sides.
BeamShape box(const DataLine& line) {
  const std::vector<double> d = dimensions(line, 0, 6);
  const double hole = (d[0] - d[2] - d[4]) * (d[1] - d[3] - d[5]);
  const double area = d[0] * d[1] - hole;
  return {.type = "BOX1",
          .numbers = {d[1], d[0], d[2], d[4], d[5], d[3]},
          .axis = 0.5 * hole / area * Eigen::Vector2d(d[2] - d[4], d[3] - d[5]),
          .size = {d[0], d[1]}};
}

// The nodes' height, height, flanges below and above (along 1), their
// thicknesses, the web's. Its shear centre parts the height between the flanges
// as t b^3.
BeamShape i_shape(const DataLine& line) {
  const double nodes = number_or(line, 0, 0.0, "height of the nodes");
  const std::vector<double> d = dimensions(line, 1, 6);
  const double below = d[3] * std::pow(d[1], 3);
  const double above = d[4] * std::pow(d[2], 3);
  const double apart = d[0] - 0.5 * (d[3] + d[4]);
  const double centre = 0.5 * d[3] + apart * above / (above + below);
  return {.type = "I",
          .numbers = {d[0], d[1], d[2], d[5], d[3], d[4]},
          .upright = true,
          .axis = {0.0, centre - nodes},
          .size = {std::max(d[1], d[2]), d[0]}};
}

// A, I11, I12, I22, J.
BeamShape general(const DataLine& line) {
  return {.type = "",
          .numbers = {number_in(line, 0, "area"),
                      number_in(line, 3, "I22"),
                      number_in(line, 1, "I11"),
                      number_or(line, 2, 0.0, "I12"),
                      number_or(line, 4, 0.0, "J")}};
}

}  // namespace

BeamShape beam_shape(const std::string& type, const DataLine& line) {
  if (type.starts_with("RECT")) return rect(line);
  if (type.starts_with("CIRC")) return circ(line);
  if (type == "PIPE" || type == "THICKPIPE") return pipe(line);
  if (type == "BOX") return box(line);
  if (type == "I") return i_shape(line);
  if (type == "GENERAL") return general(line);
  fail_at(line.place,
          fmt::format("the section {} is not read", shortened(type)),
          "Use RECT, CIRC, PIPE, BOX, I, or *BEAM GENERAL SECTION with A, I11, "
          "I12, I22, J.");
}

}  // namespace tapfit::structure
