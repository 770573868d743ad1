#include "updating/structure/mesh/stiff_corners.hpp"

#include "tests/updating/support/corner_decks.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

using namespace corner_decks;

Eigen::VectorXd frequencies(const Deck& deck) {
  const System system = assemble(deck);
  const FreeMotions motions = free_motions(system);
  return eigenmodes(motions.reduce(system.K), motions.reduce(system.M), 3)
      .frequency_hz;
}

TEST(StiffCorners, BarsEndAtTheOthersFace) {
  const std::map<int, double> inside = inside_corners(two_legs(90.0, 0.0));
  ASSERT_EQ(inside.size(), 2U);
  EXPECT_NEAR(inside.at(per_leg), 0.5 * depth / pitch, 1e-12);
  EXPECT_NEAR(inside.at(per_leg + 1), 0.5 * depth / pitch, 1e-12);
}

// Split, half of the zone's bars lie wholly inside.
TEST(StiffCorners, ReachOverSeveralBarsOfAFineMesh) {
  const Deck split = refine_mesh(two_legs(90.0, 0.0)).deck;
  const Deck again = refine_mesh(split).deck;
  double length = 0.0;
  for (const auto& [id, share] : inside_corners(again)) {
    length += share * 0.25 * pitch;
  }
  // One of them cannot be rigid as a whole.
  EXPECT_NEAR(length, depth, 2.0 * 0.1 * 0.25 * pitch + 1e-9);
}

TEST(StiffCorners, AreNoneWhereBarsGoOn) {
  EXPECT_TRUE(inside_corners(two_legs(0.0, 0.0)).empty());
  EXPECT_TRUE(inside_corners(two_legs(15.0, 0.0)).empty());
}

// As stiff as rigid arms of the same length make the frame.
TEST(StiffCorners, StiffenAsRigidArmsDo) {
  const Deck plain = two_legs(90.0, 0.0);
  const Eigen::VectorXd as_it_is = frequencies(plain);
  const Eigen::VectorXd stiff =
      frequencies(with_stiff_corners(plain, inside_corners(plain)));
  const Eigen::VectorXd arms = frequencies(two_legs(90.0, 0.5 * depth));
  for (Eigen::Index r = 0; r < 2; ++r) {
    EXPECT_GT(stiff(r), 1.005 * as_it_is(r)) << r;
    // Where in the bar it is rigid matters by half its length over the leg's.
    EXPECT_NEAR(stiff(r) - as_it_is(r),
                arms(r) - as_it_is(r),
                0.25 * (arms(r) - as_it_is(r)))
        << r;
  }
}

TEST(StiffCorners, LeaveBarsThatGoOnAsTheyAre) {
  const std::map<int, double> inside = inside_corners(meeting(false));
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_NEAR(inside.at(3), 0.5 * depth / 0.025, 1e-12);
  EXPECT_TRUE(inside_corners(meeting(true)).empty());
}

TEST(StiffCorners, LetBarsTwistUpToTheCrossing) {
  const Deck plain = two_legs(90.0, 0.0);
  const Deck stiff = with_stiff_corners(plain, inside_corners(plain));
  for (const Bar& bar : stiff.bars) {
    const BarProperty& p = stiff.bar_properties.at(bar.property);
    const double GJ = stiff.materials.at(p.material).G * p.J;
    EXPECT_NEAR(GJ, plain.materials.at(1).G * 2e-8, 1e-9 * GJ) << bar.id;
  }
}

// Two strips of shells that meet at a right angle: the row beside the fold lies
// inside by half the thickness; its mass and plane stiffness stay.
TEST(StiffCorners, ShellsBendUpToTheOthersFace) {
  const Deck deck = deck_of(
      "BEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,.1,0.,0.\nGRID,3,,.2,0.,0.\n"
      "GRID,4,,.2,0.,.1\nGRID,11,,0.,.1,0.\nGRID,12,,.1,.1,0.\n"
      "GRID,13,,.2,.1,0.\nGRID,14,,.2,.1,.1\n"
      "CQUAD4,1,1,1,2,12,11\nCQUAD4,2,1,2,3,13,12\nCQUAD4,3,1,3,4,14,13\n"
      "PSHELL,1,1,.01,1,,1\nMAT1,1,7.+10,,.3,2700.\nENDDATA\n");
  const std::map<int, double> inside = inside_corners(deck);
  ASSERT_EQ(inside.size(), 2U);
  EXPECT_NEAR(inside.at(2), 0.05, 1e-12);
  EXPECT_NEAR(inside.at(3), 0.05, 1e-12);
  const Deck stiff = with_stiff_corners(deck, inside);
  const ShellProperty& p = stiff.shell_properties.at(stiff.shells[1].property);
  EXPECT_EQ(p.membrane, 1);
  EXPECT_NEAR(stiff.materials.at(p.bending).E, 7e10 / 0.95, 1.0);
  EXPECT_EQ(total_mass(stiff, assemble(stiff)),
            total_mass(deck, assemble(deck)));
}

}  // namespace
}  // namespace tapfit::structure
