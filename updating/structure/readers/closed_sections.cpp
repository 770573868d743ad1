#include "updating/structure/readers/closed_sections.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace tapfit::structure {

BarProperty composed(const std::vector<Plate>& plates,
                     double shear_y,
                     double shear_z) {
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
    p.I12 += area * (r.y - y0) * (r.z - z0);
    p.J += std::max(r.width, r.height) *
           std::pow(std::min(r.width, r.height), 3) / 3.0;
  }
  // Of a symmetric section, rounding.
  if (std::abs(p.I12) < 1e-12 * (p.I1 + p.I2)) p.I12 = 0.0;
  p.neutral = {y0 - shear_y, z0 - shear_z};
  return p;
}

// That of the open section where a wall is as thin as nothing.
BarProperty box1(const Dimensions& d) {
  const double side = d[1] - d[2] - d[3];
  BarProperty p = composed({{d[0], d[2], d[1] - d[2] / 2.0, d[0] / 2.0},
                            {d[0], d[3], d[3] / 2.0, d[0] / 2.0},
                            {d[4], side, d[3] + side / 2.0, d[4] / 2.0},
                            {d[5], side, d[3] + side / 2.0, d[0] - d[5] / 2.0}},
                           0.0,
                           0.0);
  p.neutral.setZero();
  const double w = d[0] - 0.5 * (d[4] + d[5]);
  const double h = d[1] - 0.5 * (d[2] + d[3]);
  p.J = std::max(
      p.J, 4.0 * w * w * h * h / (w / d[2] + w / d[3] + h / d[4] + h / d[5]));
  p.K1 = (d[4] + d[5]) * d[1] / p.area;
  p.K2 = (d[2] + d[3]) * d[0] / p.area;
  return p;
}

BarProperty hat1(const Dimensions& d) {
  const double t = d[3];
  const double plate = d[4];
  const double web = d[1] - plate - t;
  const double web_z = 0.5 * (d[2] - t);
  const double foot = 0.5 * (d[0] - d[2]);
  const double foot_z = 0.5 * (d[2] + foot);
  BarProperty p = composed({{d[0], plate, plate / 2.0, 0.0},
                            {d[2], t, d[1] - t / 2.0, 0.0},
                            {t, web, plate + web / 2.0, web_z},
                            {t, web, plate + web / 2.0, -web_z},
                            {foot, t, plate + t / 2.0, foot_z},
                            {foot, t, plate + t / 2.0, -foot_z}},
                           0.0,
                           0.0);
  p.neutral.setZero();
  const double w = d[2] - t;
  const double h = d[1] - 0.5 * (t + plate);
  // Feet and plate are one beside the cell.
  p.J = 4.0 * w * w * h * h / (w / t + w / plate + 2.0 * h / t) +
        2.0 * foot * std::pow(t + plate, 3) / 3.0;
  p.K1 = 2.0 * t * d[1] / p.area;
  p.K2 = (d[0] * (t + plate)) / p.area;
  return p;
}

BarProperty double_box(const Dimensions& d) {
  const double right = d[0] - d[2];
  const double left_web = d[1] - d[6] - d[7];
  const double right_web = d[1] - d[8] - d[9];
  const double left_y = d[7] + left_web / 2.0;
  const double right_y = d[9] + right_web / 2.0;
  BarProperty p =
      composed({{d[2], d[6], d[1] - d[6] / 2.0, d[2] / 2.0},
                {d[2], d[7], d[7] / 2.0, d[2] / 2.0},
                {right, d[8], d[1] - d[8] / 2.0, d[2] + right / 2.0},
                {right, d[9], d[9] / 2.0, d[2] + right / 2.0},
                {d[3], left_web, left_y, d[3] / 2.0},
                {d[4] / 2.0, left_web, left_y, d[2] - d[4] / 4.0},
                {d[4] / 2.0, right_web, right_y, d[2] + d[4] / 4.0},
                {d[5], right_web, right_y, d[0] - d[5] / 2.0}},
               0.0,
               0.0);
  p.neutral.setZero();
  const double h1 = d[1] - 0.5 * (d[6] + d[7]);
  const double h2 = d[1] - 0.5 * (d[8] + d[9]);
  const double w1 = d[2] - 0.5 * d[3];
  const double w2 = right - 0.5 * d[5];
  const double shared = 0.5 * (h1 + h2) / d[4];
  Eigen::Matrix2d around;
  around << w1 / d[6] + w1 / d[7] + h1 / d[3] + shared, -shared, -shared,
      w2 / d[8] + w2 / d[9] + h2 / d[5] + shared;
  const Eigen::Vector2d area(w1 * h1, w2 * h2);
  p.J = 4.0 * area.dot(around.inverse() * area);
  p.K1 = (d[3] + d[4] + d[5]) * d[1] / p.area;
  p.K2 = (d[2] * (d[6] + d[7]) + right * (d[8] + d[9])) / p.area;
  return p;
}

}  // namespace tapfit::structure
