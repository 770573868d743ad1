// Grids whose displacement axes are turned: constraints, rigid elements and
// scalar elements count along them, and nothing else changes.
#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/deck/constraint_axes.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace tapfit::structure {
namespace {

// A cantilever plate of 4 by 2 elements in the axes of system 1, its clamp a
// guide along y that also lets turn about z: few of its components span axes.
std::string cantilever(const std::string& system) {
  std::string text = system +
                     "PARAM,COUPMASS,1\nMAT1,1,7.+10,,.3,2700.\n"
                     "PSHELL,1,1,.01,1,,1\n";
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; j <= 2; ++j) {
      text += fmt::format("GRID,{},1,{:.2f},{:.2f},0.,1{}\n",
                          1 + 3 * i + j,
                          0.25 * i,
                          0.25 * j,
                          i == 0 ? (j == 1 ? ",12345" : ",1345") : "");
    }
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 2; ++j) {
      const int a = 1 + 3 * i + j;
      text +=
          fmt::format("CQUAD4,{},1,{},{},{},{}\n", a, a, a + 3, a + 4, a + 1);
    }
  }
  return text;
}

TEST(TurnedAxes, CantileverSoundsTheSameWhicheverWayItLies) {
  const Deck plain =
      deck_of(cantilever("CORD2R,1,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"));
  const Deck turned =
      deck_of(cantilever("CORD2R,1,,.3,-.2,1.,1.3,.2,2.7\n,.9,1.4,.3\n"));
  EXPECT_EQ(assemble(plain).T.size(), 0);
  ASSERT_GT(assemble(turned).T.size(), 0);
  const Eigen::VectorXd f = modes_of(plain, 10).frequency_hz;
  const Eigen::VectorXd g = modes_of(turned, 10).frequency_hz;
  for (Eigen::Index k = 0; k < 10; ++k) {
    // Rounding of turning every element.
    EXPECT_NEAR(g(k) / f(k), 1.0, 1e-9) << k;
  }
  const DeckModes modes = deck_modes(turned, assemble(turned), 10);
  EXPECT_TRUE(modes.warnings.empty());
}

TEST(TurnedAxes, RollerOnASlope) {
  // A mass on springs kx = 400, ky = 100 that a slope at 30 degrees holds
  // across itself: k = kx cos^2 + ky sin^2 along it.
  const Deck deck = deck_of(
      "CORD2R,1,,0.,0.,0.,0.,0.,1.\n,.8660254037844387,.5,0.\n"
      "GRID,1,,0.,0.,0.,1,23456\nGRID,2,,0.,0.,0.,,123456\n"
      "CELAS2,1,400.,1,1\nCONM2,3,1,,1.\n"
      "PBUSH,4,K,400.,100.\nCBUSH,5,4,2,1,,,,0\n");
  // CELAS2 acts along the slope: 400 more.
  const Eigen::VectorXd f = modes_of(deck, 3).frequency_hz;
  ASSERT_EQ(f.size(), 1);
  EXPECT_NEAR(f(0), std::sqrt(400 + 400 * 0.75 + 100 * 0.25) / two_pi, 1e-9);
}

TEST(TurnedAxes, FollowerInCylindricalAxes) {
  // Grid 2 follows the hub along its radius at 30 degrees only, all else of it
  // is held: M adds cos^2 of itself to the hub's m.
  const Deck deck = deck_of(
      "CORD2C,4,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"
      "GRID,1,,0.,0.,0.,,23456\nGRID,2,4,1.,30.,0.,4,23456\n"
      "RBE2,7,1,1,2\nCELAS2,1,400.,1,1\nCONM2,3,1,,1.\nCONM2,4,2,,2.\n");
  const Eigen::VectorXd f = modes_of(deck, 3).frequency_hz;
  ASSERT_EQ(f.size(), 1);
  EXPECT_NEAR(f(0), std::sqrt(400 / (1 + 2 * 0.75)) / two_pi, 1e-9);
}

TEST(TurnedAxes, CylinderAndSpherePlaceAndTurnGrids) {
  const Deck deck = deck_of(
      "CORD2C,4,,0.,0.,1.,0.,0.,2.\n,1.,0.,1.\n"
      "CORD2S,5,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"
      "GRID,1,4,2.,90.,3.,4\nGRID,2,5,2.,90.,90.,5\nGRID,3,5,2.,30.,0.,5\n");
  const auto near = [](const Eigen::Vector3d& a, double x, double y, double z) {
    return (a - Eigen::Vector3d(x, y, z)).norm() < 1e-12;
  };
  EXPECT_TRUE(near(deck.grids[0].position, 0, 2, 4));
  EXPECT_TRUE(near(deck.grids[0].axes.col(0), 0, 1, 0));   // r
  EXPECT_TRUE(near(deck.grids[0].axes.col(1), -1, 0, 0));  // theta
  EXPECT_TRUE(near(deck.grids[1].position, 0, 2, 0));
  EXPECT_TRUE(near(deck.grids[1].axes.col(1), 0, 0, -1));  // theta: from z down
  EXPECT_TRUE(near(deck.grids[1].axes.col(2), -1, 0, 0));  // phi
  const double s = 0.5;
  const double c = std::sqrt(0.75);
  EXPECT_TRUE(near(deck.grids[2].position, 2 * s, 0, 2 * c));
  EXPECT_TRUE(near(deck.grids[2].axes.col(0), s, 0, c));
  for (const Grid& grid : deck.grids) {
    EXPECT_NEAR(grid.axes.determinant(), 1.0, 1e-12) << grid.id;
  }
}

TEST(TurnedAxes, SystemsStandInAnyOrder) {
  // Three systems, each turned by 90 degrees about the z of the one it refers
  // to and moved by 1 along its x: x of the third points along -y of basic.
  const std::string first = "CORD2R,1,,1.,0.,0.,1.,0.,1.\n,1.,1.,0.\n";
  const std::string second = "CORD2R,2,1,1.,0.,0.,1.,0.,1.\n,1.,1.,0.\n";
  const std::string third = "CORD2R,3,2,1.,0.,0.,1.,0.,1.\n,1.,1.,0.\n";
  const std::string grid = "GRID,1,3,2.,0.,0.\n";
  for (const std::string& deck : {first + second + third + grid,
                                  third + second + first + grid,
                                  grid + second + third + first}) {
    const Eigen::Vector3d place = deck_of(deck).grids.front().position;
    EXPECT_LT((place - Eigen::Vector3d(0.0, -1.0, 0.0)).norm(), 1e-14) << deck;
  }
}

TEST(TurnedAxes, SystemOnThreeGrids) {
  const Deck deck = deck_of(
      "GRID,1,,1.,1.,1.\nGRID,2,,1.,1.,2.\nGRID,3,,1.,3.,1.\n"
      "CORD1R,6,1,2,3\nGRID,4,,0.,0.,0.,6\n");
  EXPECT_LT((deck.grids[3].axes.col(0) - Eigen::Vector3d::UnitY()).norm(),
            1e-12);
}

TEST(TurnedAxes, ClampNeedsNone) {
  // All translations, or a turn by 90 degrees: basic axes do.
  const Deck deck = deck_of(
      "CORD2R,1,,0.,0.,0.,0.,0.,1.\n,.6,.8,0.\n"
      "CORD2R,2,,0.,0.,0.,0.,0.,1.\n,0.,1.,0.\n"
      "GRID,1,,0.,0.,0.,1,123\nGRID,2,,1.,0.,0.,2,15\nGRID,3,,2.,0.,0.,1,1\n"
      "SPC1,1,23,3\nGRID,4,,3.,0.,0.,1,14\n");
  const ConstraintAxes axes = constraint_axes(deck);
  EXPECT_EQ(axes.turned, (std::set<int>{4}));
  EXPECT_EQ(axes.held.at(1), "123");
  EXPECT_EQ(axes.held.at(2), "24");
  EXPECT_EQ(axes.held.at(3), "123");
  EXPECT_EQ(axes.held.at(4), "14");
  EXPECT_EQ(axes.held_in_basic(4), "");
}

TEST(TurnedAxes, NewGridsOnACylinderAreHeldAlongItsRadius) {
  Deck deck = deck_of(
      "CORD2C,4,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nMAT1,1,7.+10,,.3,2700.\n"
      "PBAR,1,1,1.-4,1.-9,1.-9,2.-9\nGRID,1,4,1.,0.,0.,4,1\n"
      "GRID,2,4,1.,90.,0.,4,1\nCBAR,1,1,1,2,0.,0.,1.\n");
  const Deck fine = refine_mesh(deck).deck;
  ASSERT_EQ(fine.grids.size(), 3U);
  ASSERT_EQ(fine.constraints.size(), 3U);
  EXPECT_EQ(fine.constraints[2].components, "1");
  const Eigen::Vector3d r = fine.grids[2].axes.col(0);
  EXPECT_LT((r - Eigen::Vector3d(1, 1, 0).normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace tapfit::structure
