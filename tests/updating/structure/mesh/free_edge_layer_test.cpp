#include "updating/structure/mesh/free_edge_layer.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::VectorXd;

// Rigid in bending, twisted: w = x y.
VectorXd twisted(const Deck& deck) {
  VectorXd u = VectorXd::Zero(6 * static_cast<Eigen::Index>(deck.grids.size()));
  Eigen::Index at = 0;
  for (const Grid& grid : deck.grids) {
    u(at + 2) = grid.position.x() * grid.position.y();
    u(at + 3) = grid.position.x();
    u(at + 4) = -grid.position.y();
    at += 6;
  }
  return u;
}

// The work of 2 D66 at a unit of twist, less a width delta along every edge.
TEST(EdgeTwist, TakesALayerOffEveryEdge) {
  Plate plate{.a = 0.5, .b = 0.2, .thickness = 0.004};
  const Deck deck = plate_deck(plate, 10, 4);
  const VectorXd u = twisted(deck);
  const double G = plate.material.G;
  const double D66 = G * std::pow(plate.thickness, 3) / 12.0;
  const double delta = plate.thickness / std::sqrt(10.0);
  const double whole = 4.0 * D66 * plate.a * plate.b;
  EXPECT_NEAR(u.dot(assemble(deck).K * u), whole, 1e-9 * whole);
  EXPECT_NEAR(u.dot(free_edge_layer(deck) * u),
              4.0 * D66 * delta * 2.0 * (plate.a + plate.b),
              1e-9 * whole);
}

// Each edge has the layer of the transverse shear that runs along it, however
// the element and its material are turned.
TEST(EdgeTwist, FollowsTheMaterialsAxes) {
  Plate plate{.a = 0.5, .b = 0.2, .thickness = 0.004};
  plate.material = {1, true, 11e9, 0.4, 0.7e9, 400.0, 0.9e9, 0.75e9, 0.1e9};
  Deck deck = plate_deck(plate, 10, 4);
  for (std::size_t k = 0; k < deck.shells.size(); k += 2) {
    Shell& shell = deck.shells[k];
    std::rotate(
        shell.grids.begin(), shell.grids.begin() + 1, shell.grids.end());
    shell.theta_deg = -90.0;
  }
  const VectorXd u = twisted(deck);
  const double D66 = plate.material.G * std::pow(plate.thickness, 3) / 12.0;
  const double shear = 5.0 / 6.0 * plate.thickness;
  const double along_x = std::sqrt(D66 / (plate.material.G1z * shear));
  const double along_y = std::sqrt(D66 / (plate.material.G2z * shear));
  const double expected =
      4.0 * D66 * 2.0 * (along_x * plate.a + along_y * plate.b);
  EXPECT_NEAR(u.dot(free_edge_layer(deck) * u), expected, 1e-9 * expected);
}

// Lines that resolve the layer at both ends of [0, length]: 1/8 of the
// thickness at the edge, growing by half from one to the next up to `most`.
std::vector<double> graded(double length, double thickness, double most) {
  std::vector<double> half = {0.0};
  for (double step = thickness / 8.0; half.back() + step < length / 2.0;
       step = std::min(1.5 * step, most)) {
    half.push_back(half.back() + step);
  }
  std::vector<double> lines = half;
  lines.push_back(length / 2.0);
  for (std::size_t k = half.size(); k-- > 0;) lines.push_back(length - half[k]);
  return lines;
}

double first_twist_hz(const Deck& deck, double layers) {
  System system = assemble(deck);
  system.K -= layers * free_edge_layer(deck);
  const FreeMotions motions = free_motions(system);
  const Eigenmodes modes =
      eigenmodes(motions.reduce(system.K), motions.reduce(system.M), 8);
  const Eigen::MatrixXd u = motions.expand(modes.phi);
  // The lowest elastic mode whose two corners at x = 0 move against each other.
  Eigen::Index first = 0;
  Eigen::Index last = 0;
  for (std::size_t k = 0; k < deck.grids.size(); ++k) {
    const Eigen::Vector3d& x = deck.grids[k].position;
    if (x.norm() < 1e-12) first = static_cast<Eigen::Index>(k);
    if (x.x() < 1e-12 &&
        x.y() > deck.grids[static_cast<std::size_t>(last)].position.y()) {
      last = static_cast<Eigen::Index>(k);
    }
  }
  for (Eigen::Index r = 6; r < 8; ++r) {
    if (u(6 * first + 2, r) * u(6 * last + 2, r) < 0.0) {
      return modes.frequency_hz(r);
    }
  }
  return 0.0;
}

// A coarse strip against one whose mesh sees the layer everywhere: 3 % of the
// torsional stiffness is the edges'.
TEST(EdgeTwist, GivesACoarseStripTheTorsionOfAFineOne) {
  Plate plate{.a = 0.4, .b = 0.1, .thickness = 0.005};
  const double coarse = first_twist_hz(plate_deck(plate, 16, 4), 0.0);
  const double mended = first_twist_hz(plate_deck(plate, 16, 4), 1.0);
  const std::vector<double> x = graded(plate.a, plate.thickness, 0.006);
  const std::vector<double> y = graded(plate.b, plate.thickness, 0.006);
  const int nx = static_cast<int>(x.size()) - 1;
  const int ny = static_cast<int>(y.size()) - 1;
  Deck fine = plate_deck(plate, nx, ny);
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      fine.grids[static_cast<std::size_t>(i * (ny + 1) + j)].position = {
          x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)], 0.0};
    }
  }
  const double exact = first_twist_hz(fine, 0.0);
  EXPECT_GT(coarse / exact - 1.0, 0.012);
  // Towards the ends of the strip the layers of two edges meet.
  EXPECT_NEAR(mended / exact, 1.0, 0.004);
}

TEST(EdgeTwist, IsNothingWithoutTransverseShear) {
  const Plate plate{.shear = false};
  EXPECT_EQ(free_edge_layer(plate_deck(plate, 4, 4)).nonZeros(), 0);
}

// At most a quarter of an element: twist stays resisted there.
TEST(EdgeTwist, LeavesFineElementsMostOfTheirTwist) {
  const Plate plate{.a = 0.1, .b = 0.1, .thickness = 0.05};
  const Deck deck = plate_deck(plate, 10, 10);
  const VectorXd u = twisted(deck);
  const double D66 = plate.material.G * std::pow(plate.thickness, 3) / 12.0;
  EXPECT_NEAR(
      u.dot(free_edge_layer(deck) * u), 4.0 * D66 * 0.0025 * 0.4, 1e-9 * D66);
}

}  // namespace
}  // namespace tapfit::structure
