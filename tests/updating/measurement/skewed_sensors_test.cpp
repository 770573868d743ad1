// Sensors askew to the axes, above the structure and between its grids against
// the closed form of a cantilever,
//
//   w = cosh b x - cos b x - c (sinh b x - sin b x),  a = d_z w - d_x h w'
//
// for a point at x, h above the axis, and a direction d. The table in
// docs/decks.md is of these numbers.
#include "tests/updating/support/deck_support.hpp"
#include "updating/measurement/place_points.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;

constexpr int bars = 40;

structure::Deck cantilever() {
  structure::Deck deck;
  deck.coupled_mass = true;
  deck.materials[1] = {1, false, 210e9, 0.3, 210e9 / 2.6, 7800, 0, 0, 0};
  deck.bar_properties[1] = {1, 1, 4e-4, 1e-8, 1e-5, 0.0, 2e-8};
  for (int i = 0; i <= bars; ++i) {
    deck.grids.push_back({i + 1, Vector3d(1.0 * i / bars, 0.0, 0.0)});
  }
  for (int i = 1; i <= bars; ++i) {
    deck.bars.push_back(structure::make_bar(i, 1, i, i + 1));
  }
  deck.constraints.push_back({1, "123456"});
  return deck;
}

struct Sensor {
  double x, height;  // of the sensing element above the axis [m]
  Vector3d direction;
};

// In shares of what the tip does along z.
double closed_form(double root, const Sensor& sensor) {
  const double c =
      (std::cosh(root) + std::cos(root)) / (std::sinh(root) + std::sin(root));
  const auto w = [&](double x) {
    const double b = root * x;
    return std::cosh(b) - std::cos(b) - c * (std::sinh(b) - std::sin(b));
  };
  const double b = root * sensor.x;
  const double slope =
      root * (std::sinh(b) + std::sin(b) - c * (std::cosh(b) - std::cos(b)));
  const Vector3d d = sensor.direction.normalized();
  return (d.z() * w(sensor.x) - d.x() * sensor.height * slope) / w(1.0);
}

TEST(SkewedSensors, AreThoseOfTheClosedForm) {
  const std::vector<Sensor> sensors{{0.83, 0.0, {0.0, 0.4061, 0.9138}},
                                    {0.517, 0.0, {0.0, -0.5, 0.7}},
                                    {0.9631, 0.03, {3.0, 6.0, 8.0}},
                                    {0.71, 0.03, {1.0, 0.0, 0.0}},
                                    {0.3, -0.02, {1.0, 0.0, 1.0}}};
  acquisition::TestBundle bundle;
  std::set<int> used;
  for (const Sensor& sensor : sensors) {
    acquisition::TestPoint point;
    point.label = static_cast<int>(bundle.points.size()) + 1;
    point.at = Vector3d(sensor.x, 0.0, sensor.height);
    // What is measured is the third axis.
    point.axes =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), sensor.direction)
            .toRotationMatrix();
    bundle.points.push_back(point);
    used.insert(point.label);
  }
  structure::Deck deck = cantilever();
  place_points(bundle, used, deck);
  const structure::System system = structure::assemble(deck);
  const structure::FreeMotions motions = structure::free_motions(system);
  const Eigen::MatrixXd u =
      motions.expand(structure::eigenmodes(
                         motions.reduce(system.K), motions.reduce(system.M), 3)
                         .phi);
  const auto row = [&](int grid) {
    return u.row(6 * static_cast<Eigen::Index>(deck.grid_index(grid)) + 2);
  };
  const std::vector<double> roots{1.8751040687, 4.6940911330, 7.8547574382};
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    for (std::size_t r = 0; r < roots.size(); ++r) {
      const auto mode = static_cast<Eigen::Index>(r);
      const double found =
          row(-static_cast<int>(s) - 1)(mode) / row(bars + 1)(mode);
      // Turns are linear between grids, a fortieth of the length apart: of
      // height times w''' h^2 / 8 at most 2e-4.
      EXPECT_NEAR(found, closed_form(roots[r], sensors[s]), 2e-4)
          << "sensor " << s + 1 << ", mode " << r + 1;
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
