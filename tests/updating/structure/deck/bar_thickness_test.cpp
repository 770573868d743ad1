#include "updating/structure/deck/bar_thickness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

// Torsion of a rectangle, w >= t or less; Timoshenko and Goodier, eq. 163:
//   J = w t^3 (1 - 192 t / (pi^5 w) sum tanh(n pi w / (2 t)) / n^5) / 3, n odd
double torsion_constant(double w, double t) {
  double sum = 0.0;
  for (int n = 1; n < 40; n += 2) {
    sum += std::tanh(n * std::numbers::pi * w / (2.0 * t)) / std::pow(n, 5.0);
  }
  const double pi5 = std::pow(std::numbers::pi, 5.0);
  return w * t * t * t / 3.0 * (1.0 - 192.0 * t / (pi5 * w) * sum);
}

BarProperty rectangle(double w, double t) {
  BarProperty bar;
  bar.area = w * t;
  bar.I1 = w * t * t * t / 12.0;
  bar.I2 = t * w * w * w / 12.0;
  bar.J = torsion_constant(w, t);
  return bar;
}

// Of a square exactly, by symmetry; of others as Saint-Venant's formula is
// right: its own error changes by 3 % from a square to a strip.
TEST(BarThickness, TakesFromTwistWhatARectangleLoses) {
  constexpr double h = 1e-4;
  for (const double w : {1.0, 1.5, 2.0, 5.0, 20.0}) {
    const double slope =
        std::log(torsion_constant(w, 1.0 + h) / torsion_constant(w, 1.0 - h)) /
        (2.0 * h);
    const double b = twist_by_thickness(rectangle(w, 1.0));
    EXPECT_NEAR(3.0 - 2.0 * b, slope, w == 1.0 ? 1e-6 : 0.08) << w;
  }
}

TEST(BarThickness, IsToldByTheSofterPlane) {
  const BarProperty flat = rectangle(2.0, 1.0);
  EXPECT_EQ(bends_across(flat), (std::array{true, false}));
  EXPECT_EQ(bends_across(rectangle(1.0, 2.0)), (std::array{false, true}));
  EXPECT_EQ(bends_across(rectangle(1.0, 1.0)), (std::array{true, true}));
}

}  // namespace
}  // namespace tapfit::structure
