#include "modal/poles/cauchy_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;

// A square's corners are sqrt(2)/2 of its width off, the width is an eighth or
// less of the distance to the lines, and the middle is as much nearer to them.
TEST(CauchyCell, HoldsItsPlaceFarFromAllLines) {
  constexpr double last = 100.0;
  const double corner = std::sqrt(0.5) / 8.0;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-30.0, 130.0);
  std::uniform_real_distribution<double> decade(-4.0, 4.0);
  for (int trial = 0; trial < 1000; ++trial) {
    const double side = trial % 2 == 0 ? -1.0 : 1.0;
    const Complex a(place(random), side * std::pow(10.0, decade(random)));
    const CauchyCell cell = CauchyCell::of(a, last);
    EXPECT_LE(std::abs(a - cell.centre()), cell.radius() * (1.0 + 1e-12));
    const Complex c = cell.centre();
    const double nearest = std::round(std::clamp(c.real(), 0.0, last));
    EXPECT_LT(cell.radius(), corner / (1.0 - corner) * std::abs(c - nearest));
  }
}

TEST(CauchyCells, WorkOutEachSquareOnce) {
  CauchyCells cells;
  int worked_out = 0;
  const auto expanded = [&worked_out] {
    ++worked_out;
    return Eigen::MatrixXcd::Constant(1, 1, worked_out).eval();
  };
  const CauchyCell one = CauchyCell::of({10.0, 2.0}, 50.0);
  const CauchyCell other = CauchyCell::of({10.0, 4.0}, 50.0);
  EXPECT_EQ((*cells.find(one, expanded))(0, 0), 1.0);
  EXPECT_EQ((*cells.find(other, expanded))(0, 0), 2.0);
  EXPECT_EQ((*cells.find(one, expanded))(0, 0), 1.0);
  EXPECT_EQ(worked_out, 2);
}

}  // namespace
}  // namespace tapfit::modal
