// Cross sections of PBARL and PBEAML: area, second moments about the centroid,
// torsion constant (thin-walled or Roark's formula for the rectangle), shear
// factors, and where the centroid lies from the shear centre (thin-walled).
//
// Source: MSC Nastran Quick Reference Guide, PBARL, PBEAML; W. C. Young,
// Roark's Formulas for Stress and Strain, 7th ed., tables 9.2 and 10.1.
#include "updating/structure/readers/closed_sections.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace tapfit::structure {
namespace {

using std::numbers::pi;

// J = a b^3 (1/3 - 0.21 b/a (1 - b^4/(12 a^4))), a >= b.
double rectangle_torsion(double w, double h) {
  const double a = std::max(w, h);
  const double b = std::min(w, h);
  const double ratio = b / a;
  return a * b * b * b *
         (1.0 / 3.0 - 0.21 * ratio * (1.0 - std::pow(ratio, 4) / 12.0));
}

BarProperty tube(double outer, double inner) {
  BarProperty p;
  p.area = pi * (outer * outer - inner * inner);
  p.I1 = p.I2 = pi / 4.0 * (std::pow(outer, 4) - std::pow(inner, 4));
  p.J = 2.0 * p.I1;
  p.K1 = p.K2 = inner > 0.0 ? 0.5 : 0.9;
  return p;
}

// Width along element z, height along element y (plane 1).
BarProperty rectangle(double width, double height) {
  BarProperty p;
  p.area = width * height;
  p.I1 = width * std::pow(height, 3) / 12.0;
  p.I2 = height * std::pow(width, 3) / 12.0;
  p.J = rectangle_torsion(width, height);
  p.K1 = p.K2 = 5.0 / 6.0;
  return p;
}

// t1: top and bottom walls, t2: side walls.
BarProperty box(double w, double h, double t1, double t2) {
  const double wi = w - 2.0 * t2;
  const double hi = h - 2.0 * t1;
  BarProperty p;
  p.area = w * h - wi * hi;
  p.I1 = (w * std::pow(h, 3) - wi * std::pow(hi, 3)) / 12.0;
  p.I2 = (h * std::pow(w, 3) - hi * std::pow(wi, 3)) / 12.0;
  p.J = 2.0 * t1 * t2 * std::pow(w - t2, 2) * std::pow(h - t1, 2) /
        (w * t2 + h * t1 - t2 * t2 - t1 * t1);
  p.K1 = 2.0 * h * t2 / p.area;
  p.K2 = 2.0 * w * t1 / p.area;
  return p;
}

// d: height, bottom width, top width, web, bottom flange, top flange.
BarProperty i_beam(const Dimensions& d) {
  const double web = d[0] - d[4] - d[5];
  const double bottom = d[4] * std::pow(d[1], 3);
  const double top = d[5] * std::pow(d[2], 3);
  const double apart = d[0] - 0.5 * (d[4] + d[5]);
  BarProperty p = composed({{d[1], d[4], d[4] / 2.0, 0.0},
                            {d[3], web, d[4] + web / 2.0, 0.0},
                            {d[2], d[5], d[0] - d[5] / 2.0, 0.0}},
                           d[4] / 2.0 + apart * top / (top + bottom),
                           0.0);
  p.K1 = d[3] * d[0] / p.area;
  p.K2 = 5.0 / 6.0 * (d[1] * d[4] + d[2] * d[5]) / p.area;
  return p;
}

// d: flange overhangs together, web, height of the web, total height.
BarProperty i1_beam(const Dimensions& d) {
  const double flange = 0.5 * (d[3] - d[2]);
  return i_beam({d[3], d[0] + d[1], d[0] + d[1], d[1], flange, flange});
}

// d: flange width, total height, flange thickness, web thickness; the flange on
// top, or below.
BarProperty tee(const Dimensions& d, bool on_top) {
  const double web = d[1] - d[2];
  const double flange_y = on_top ? d[1] - d[2] / 2.0 : d[2] / 2.0;
  const double web_y = on_top ? web / 2.0 : d[2] + web / 2.0;
  BarProperty p = composed(
      {{d[0], d[2], flange_y, 0.0}, {d[3], web, web_y, 0.0}}, flange_y, 0.0);
  p.K1 = d[3] * d[1] / p.area;
  p.K2 = d[0] * d[2] / p.area;
  return p;
}

// The section turned by a right angle: y takes the place of z.
BarProperty turned(BarProperty p) {
  std::swap(p.I1, p.I2);
  std::swap(p.K1, p.K2);
  p.I12 = -p.I12;
  p.neutral = {-p.neutral.y(), p.neutral.x()};
  return p;
}

// d: width, height, web thickness, flange thickness. The shear centre lies
// beyond the web, 3 b^2 t / (6 b t + h w) from its middle; z points that way.
BarProperty channel(const Dimensions& d) {
  const double flange = d[0] - d[2];
  const double z = -(d[2] + flange) / 2.0;
  const double b = d[0] - d[2] / 2.0;
  const double beyond =
      3.0 * b * b * d[3] / (6.0 * b * d[3] + (d[1] - d[3]) * d[2]);
  BarProperty p = composed({{d[2], d[1], d[1] / 2.0, 0.0},
                            {flange, d[3], d[3] / 2.0, z},
                            {flange, d[3], d[1] - d[3] / 2.0, z}},
                           d[1] / 2.0,
                           beyond);
  p.K1 = d[2] * d[1] / p.area;
  p.K2 = 2.0 * flange * d[3] / p.area;
  return p;
}

// d: overhang, web, height of the web, total height; one flange each way.
BarProperty zee(const Dimensions& d) {
  const double t = 0.5 * (d[3] - d[2]);
  const double z = 0.5 * d[0];
  BarProperty p = composed({{d[1], d[2], 0.0, 0.0},
                            {d[0] + d[1], t, 0.5 * (d[3] - t), -z},
                            {d[0] + d[1], t, -0.5 * (d[3] - t), z}},
                           0.0,
                           0.0);
  p.K1 = d[1] * d[3] / p.area;
  p.K2 = 5.0 / 6.0 * 2.0 * (d[0] + d[1]) * t / p.area;
  return p;
}

// d: width, height, thickness of the leg along z, of the one along y.
BarProperty angle(const Dimensions& d) {
  const double leg = d[1] - d[2];
  BarProperty p = composed({{d[0], d[2], d[2] / 2.0, -d[0] / 2.0},
                            {d[3], leg, d[2] + leg / 2.0, -d[3] / 2.0}},
                           d[2] / 2.0,
                           -d[3] / 2.0);
  p.K1 = 5.0 / 6.0 * d[3] * d[1] / p.area;
  p.K2 = 5.0 / 6.0 * d[2] * d[0] / p.area;
  return p;
}

// d: arms together, upright's thickness, its height, arms' thickness.
BarProperty cross(const Dimensions& d) {
  BarProperty p = composed({{d[1], d[2], 0.0, 0.0},
                            {d[0] / 2.0, d[3], 0.0, (d[0] + 2 * d[1]) / 4.0},
                            {d[0] / 2.0, d[3], 0.0, -(d[0] + 2 * d[1]) / 4.0}},
                           0.0,
                           0.0);
  p.J = (d[2] * std::pow(d[1], 3) + d[0] * std::pow(d[3], 3)) / 3.0;
  p.K1 = 5.0 / 6.0 * d[1] * d[2] / p.area;
  p.K2 = 5.0 / 6.0 * (d[0] + d[1]) * d[3] / p.area;
  return p;
}

// d: between the legs, legs' thickness together, their height, the web's.
BarProperty h_beam(const Dimensions& d) {
  const double z = 0.5 * (d[0] + 0.5 * d[1]);
  BarProperty p = composed({{d[0], d[3], 0.0, 0.0},
                            {d[1] / 2.0, d[2], 0.0, z},
                            {d[1] / 2.0, d[2], 0.0, -z}},
                           0.0,
                           0.0);
  p.K1 = 5.0 / 6.0 * d[1] * d[2] / p.area;
  p.K2 = d[3] * (d[0] + d[1]) / p.area;
  return p;
}

// d: height, thickness, width of the top, flange beyond each web.
BarProperty hat(const Dimensions& d) {
  const double t = d[1];
  const double web = d[0] - 2.0 * t;
  const double web_z = 0.5 * (d[2] - t);
  const double foot = d[3] + t;
  const double foot_z = web_z - 0.5 * t + 0.5 * foot;
  BarProperty p = composed({{d[2], t, d[0] - t / 2.0, 0.0},
                            {t, web, d[0] / 2.0, web_z},
                            {t, web, d[0] / 2.0, -web_z},
                            {foot, t, t / 2.0, foot_z},
                            {foot, t, t / 2.0, -foot_z}},
                           0.0,
                           0.0);
  p.neutral.setZero();
  p.K1 = 2.0 * t * d[0] / p.area;
  p.K2 = t * (d[2] + 2.0 * foot) / p.area;
  return p;
}

// d: width of a pointed end, total width, height.
BarProperty hexagon(const Dimensions& d) {
  const double flat = d[1] - 2.0 * d[0];
  const double h = d[2];
  BarProperty p;
  p.area = (d[1] - d[0]) * h;
  // Each end is two right triangles of d0 by h / 2.
  p.I1 = flat * h * h * h / 12.0 + d[0] * h * h * h / 24.0;
  const double end = 0.5 * d[0] * h;  // area of one end
  p.I2 = h * std::pow(flat, 3) / 12.0 +
         2.0 * (h * std::pow(d[0], 3) / 36.0 +
                end * std::pow(flat / 2.0 + d[0] / 3.0, 2));
  // Saint-Venant's approximation for compact sections.
  p.J = std::pow(p.area, 4) / (4.0 * pi * pi * (p.I1 + p.I2));
  p.K1 = p.K2 = 5.0 / 6.0;
  return p;
}

struct Shape {
  std::size_t dimensions;
  bool (*fits)(const Dimensions&);  // walls inside
  BarProperty (*section)(const Dimensions&);
};

bool always(const Dimensions& /*d*/) { return true; }

const std::map<std::string, Shape>& shapes() {
  using D = const Dimensions&;
  static const std::map<std::string, Shape> known_shapes{
      {"ROD", {1, always, [](D d) { return tube(d[0], 0.0); }}},
      {"TUBE",
       {2,
        [](D d) { return d[1] < d[0]; },
        [](D d) { return tube(d[0], d[1]); }}},
      {"TUBE2",
       {2,
        [](D d) { return d[1] <= d[0]; },
        [](D d) { return tube(d[0], d[0] - d[1]); }}},
      {"BAR", {2, always, [](D d) { return rectangle(d[0], d[1]); }}},
      {"BOX",
       {4,
        [](D d) { return 2.0 * d[2] < d[1] && 2.0 * d[3] < d[0]; },
        [](D d) { return box(d[0], d[1], d[2], d[3]); }}},
      {"BOX1",
       {6, [](D d) { return d[2] + d[3] < d[1] && d[4] + d[5] < d[0]; }, box1}},
      {"I", {6, [](D d) { return d[4] + d[5] < d[0]; }, i_beam}},
      {"I1", {4, [](D d) { return d[2] < d[3]; }, i1_beam}},
      {"T",
       {4, [](D d) { return d[2] < d[1]; }, [](D d) { return tee(d, true); }}},
      // Flange height, web length, flange thickness, web thickness.
      {"T1",
       {4,
        always,
        [](D d) {
          return turned(tee({d[0], d[1] + d[2], d[2], d[3]}, true));
        }}},
      {"T2",
       {4, [](D d) { return d[2] < d[1]; }, [](D d) { return tee(d, false); }}},
      {"CHAN",
       {4, [](D d) { return d[2] < d[0] && 2.0 * d[3] < d[1]; }, channel}},
      // Overhang, web, height of the web, total height.
      {"CHAN1",
       {4,
        [](D d) { return d[2] < d[3]; },
        [](D d) {
          return channel({d[0] + d[1], d[3], d[1], 0.5 * (d[3] - d[2])});
        }}},
      // Legs' thickness, web's, height, width.
      {"CHAN2",
       {4,
        [](D d) { return 2.0 * d[0] < d[3] && d[1] < d[2]; },
        [](D d) {
          return turned(channel({d[2], d[3], d[1], d[0]}));
        }}},
      {"Z", {4, [](D d) { return d[2] < d[3]; }, zee}},
      {"L", {4, [](D d) { return d[2] < d[1] && d[3] < d[0]; }, angle}},
      {"CROSS", {4, [](D d) { return d[3] < d[2]; }, cross}},
      {"H", {4, [](D d) { return d[3] < d[2]; }, h_beam}},
      {"HAT",
       {4, [](D d) { return 2.0 * d[1] < d[0] && 2.0 * d[1] < d[2]; }, hat}},
      {"HAT1",
       {5,
        [](D d) {
          return d[3] + d[4] < d[1] && 2.0 * d[3] < d[2] && d[2] <= d[0];
        },
        hat1}},
      {"DBOX",
       {10,
        [](D d) {
          return d[6] + d[7] < d[1] && d[8] + d[9] < d[1] &&
                 d[3] + d[4] / 2.0 < d[2] && d[2] + d[4] / 2.0 + d[5] < d[0];
        },
        double_box}},
      {"HEXA", {3, [](D d) { return 2.0 * d[0] < d[1]; }, hexagon}}};
  return known_shapes;
}

}  // namespace

std::size_t section_dimensions(const std::string& type) {
  const auto found = shapes().find(type);
  return found == shapes().end() ? 0 : found->second.dimensions;
}

std::string known_sections() {
  std::string names;
  for (const auto& [name, shape] : shapes()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

std::optional<BarProperty> section_of(const std::string& type,
                                      const std::vector<double>& d) {
  const auto found = shapes().find(type);
  if (found == shapes().end()) return {};
  const bool hollow = type == "TUBE";
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (d[i] < 0.0 || (d[i] == 0.0 && !(hollow && i == 1))) return {};
  }
  if (!found->second.fits(d)) return {};
  BarProperty p = found->second.section(d);
  if (!(p.area > 0.0)) return {};
  return p;
}

}  // namespace tapfit::structure
