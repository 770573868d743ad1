#include "updating/diagnosis/place_parabola.hpp"

#include "acquisition/foundation/seeded_random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// A place known to 3 mm along x and 6 mm along y around the first, where the
// size grows by 5 in the logarithm for each metre of x.
TriedPlace tried(double x, double y) {
  const double down = std::pow(x / 0.003, 2) + std::pow(y / 0.006, 2);
  return {{x, y, 0.1}, -0.5 * down, VectorXd::Constant(1, 5.0 * x)};
}

std::vector<TriedPlace> cross(double step) {
  return {tried(0.0, 0.0),
          tried(step, 0.0),
          tried(-step, 0.0),
          tried(0.0, step),
          tried(0.0, -step)};
}

TEST(APlacesParabola, TellsThePlaceAndHowTheSizeGoesWithIt) {
  const auto places = cross(0.005);
  const auto q = parabola_through(places, places.front());
  ASSERT_TRUE(q);
  EXPECT_NEAR(q->top.norm(), 0.0, 1e-9);
  const Eigen::MatrixXd place = q->axes * q->covariance * q->axes.transpose();
  EXPECT_NEAR(std::sqrt(place(0, 0)), 0.003, 1e-9);
  EXPECT_NEAR(std::sqrt(place(1, 1)), 0.006, 1e-9);
  EXPECT_NEAR(size_deviations(*q).at(0), 5.0 * 0.003, 1e-9);
}

// Those off to the sides all lie on one line: a slope along x and one that
// turns with y are told from each other by rounding alone.
TEST(APlacesParabola, SaysNothingOfWhatItsPlacesDoNotTell) {
  acquisition::SeededRandom random(1, "rounding");
  std::vector<TriedPlace> places;
  const auto add = [&](double x, double y, double scatter) {
    places.push_back(tried(x, y));
    for (double& at : places.back().at) at += 1e-16 * random.normal();
    places.back().log_p(0) += scatter;  // fits end not quite where they would
  };
  for (const double y : {0.0, 1.0, 3.0, -1.0, 2.0}) add(0.0, 0.002 * y, 0.0);
  add(-0.004, 0.002, 1e-3);
  add(0.004, 0.002, 2e-3);
  add(-0.002, 0.002, -1e-3);
  add(0.002, 0.002, 1e-3);
  const auto q = parabola_through(places, places.front());
  ASSERT_TRUE(q);
  EXPECT_NEAR(size_deviations(*q).at(0), 5.0 * 0.003, 0.001);
}

// At an edge nothing lies beyond, and two places tell of the way inside: what
// is not told of the one direction is no slope of the other. A spring at the
// edge of a bent plate, as it was looked for: its size had a deviation of 113
// %.
TEST(APlacesParabola, ReadsTheSlopeOfSizesAtAnEdge) {
  const auto at = [](double x, double y, double z, double down, double size) {
    return TriedPlace{{x, y, z}, down, VectorXd::Constant(1, size)};
  };
  const std::vector<TriedPlace> places = {
      at(0.0419748, 0.21, -0.00125962, -0.22094, -0.111099),
      at(0.0419748, 0.1995, -0.00125962, -19.6124, -0.103231),
      at(0.0314858, 0.21, -0.000787299, -9.3186, 0.11685),
      at(0.0524449, 0.21, -0.00204635, -19.5818, -0.317383),
      at(0.0419748, 0.20475, -0.00125962, -9.15063, -0.104),
      at(0.0367303, 0.21, -0.00102346, 0.0, 0.0),
      at(0.0472098, 0.21, -0.00165299, -10.9713, -0.216859)};
  const auto q = parabola_through(places, places[5]);
  ASSERT_TRUE(q);
  // 21 per metre of x, which the likelihood tells to some 2 mm.
  EXPECT_NEAR(size_deviations(*q).at(0), 21.0 * 0.002, 0.02);
}

TEST(APlacesParabola, NeedsPlacesEnough) {
  std::vector<TriedPlace> places = cross(0.005);
  places.pop_back();
  EXPECT_FALSE(parabola_through(places, places.front()));
}

}  // namespace
}  // namespace tapfit::updating
