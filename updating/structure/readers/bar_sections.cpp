// Cross sections of PBARL: area, second moments about the centroid, torsion
// constant (thin-walled or Roark's formula for the rectangle), shear factors.
//
// Source: MSC Nastran Quick Reference Guide, PBARL; W. C. Young, Roark's
// Formulas for Stress and Strain, 7th ed., table 10.1.
#include "updating/structure/readers/deck_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

constexpr double kPi = std::numbers::pi;

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
  p.area = kPi * (outer * outer - inner * inner);
  p.I1 = p.I2 = kPi / 4.0 * (std::pow(outer, 4) - std::pow(inner, 4));
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

// A section of rectangles stacked along element y, each centred on z = z0.
struct Plate {
  double width, height, y, z;
};

BarProperty stacked(const std::vector<Plate>& plates) {
  BarProperty p;
  double first_y = 0.0;
  double first_z = 0.0;
  for (const Plate& r : plates) {
    const double area = r.width * r.height;
    p.area += area;
    first_y += area * r.y;
    first_z += area * r.z;
  }
  const double y0 = first_y / p.area;
  const double z0 = first_z / p.area;
  for (const Plate& r : plates) {
    const double area = r.width * r.height;
    p.I1 += area * (r.height * r.height / 12.0 + std::pow(r.y - y0, 2));
    p.I2 += area * (r.width * r.width / 12.0 + std::pow(r.z - z0, 2));
    p.J += std::max(r.width, r.height) *
           std::pow(std::min(r.width, r.height), 3) / 3.0;
  }
  return p;
}

// d: height, bottom width, top width, web, bottom flange, top flange.
BarProperty i_beam(const std::vector<double>& d) {
  const double web = d[0] - d[4] - d[5];
  BarProperty p = stacked({{d[1], d[4], d[4] / 2.0, 0.0},
                           {d[3], web, d[4] + web / 2.0, 0.0},
                           {d[2], d[5], d[0] - d[5] / 2.0, 0.0}});
  p.K1 = d[3] * d[0] / p.area;
  p.K2 = 5.0 / 6.0 * (d[1] * d[4] + d[2] * d[5]) / p.area;
  return p;
}

// d: flange width, total height, flange thickness, web thickness.
BarProperty tee(const std::vector<double>& d) {
  const double web = d[1] - d[2];
  BarProperty p = stacked(
      {{d[0], d[2], d[1] - d[2] / 2.0, 0.0}, {d[3], web, web / 2.0, 0.0}});
  p.K1 = d[3] * d[1] / p.area;
  p.K2 = d[0] * d[2] / p.area;
  return p;
}

// d: width, height, web thickness, flange thickness. Shear centre is taken at
// the centroid, as PBARL users of this subset put it there with offsets.
BarProperty channel(const std::vector<double>& d) {
  const double flange = d[0] - d[2];
  const double z = d[2] + flange / 2.0;
  BarProperty p = stacked({{d[2], d[1], d[1] / 2.0, d[2] / 2.0},
                           {flange, d[3], d[3] / 2.0, z},
                           {flange, d[3], d[1] - d[3] / 2.0, z}});
  p.K1 = d[2] * d[1] / p.area;
  p.K2 = 2.0 * flange * d[3] / p.area;
  return p;
}

}  // namespace

std::size_t section_dimensions(const std::string& type) {
  if (type == "ROD") return 1;
  if (type == "TUBE" || type == "TUBE2" || type == "BAR") return 2;
  if (type == "BOX" || type == "T" || type == "CHAN") return 4;
  return type == "I" ? 6 : 0;
}

std::optional<BarProperty> section_of(const std::string& type,
                                      const std::vector<double>& d) {
  const bool hollow = type == "TUBE";
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (d[i] < 0.0 || (d[i] == 0.0 && !(hollow && i == 1))) return {};
  }
  BarProperty p;
  if (type == "ROD") p = tube(d[0], 0.0);
  if (type == "TUBE" && d[1] < d[0]) p = tube(d[0], d[1]);
  if (type == "TUBE2" && d[1] <= d[0]) p = tube(d[0], d[0] - d[1]);
  if (type == "BAR") p = rectangle(d[0], d[1]);
  if (type == "BOX" && 2.0 * d[2] < d[1] && 2.0 * d[3] < d[0]) {
    p = box(d[0], d[1], d[2], d[3]);
  }
  if (type == "I" && d[4] + d[5] < d[0]) p = i_beam(d);
  if (type == "T" && d[2] < d[1]) p = tee(d);
  if (type == "CHAN" && d[2] < d[0] && 2.0 * d[3] < d[1]) p = channel(d);
  if (!(p.area > 0.0)) return {};
  return p;
}

}  // namespace tapfit::structure
