#include "updating/structure/mesh/corner_mass.hpp"

#include "tests/updating/support/corner_decks.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::structure {
namespace {

using namespace corner_decks;

double mass_of(const Deck& deck) { return total_mass(deck, assemble(deck)); }

// A member that ends inside another counts half the other's depth twice; mass
// that is no material's stays.
TEST(CornerMass, WeighMaterialOnce) {
  const Deck deck = meeting(false);
  const Deck once = with_placed_mass(deck);
  const double lost = mass_of(deck) - mass_of(once);
  EXPECT_NEAR(lost, 7850.0 * depth * depth * 0.5 * depth, 1e-3 * lost);
  EXPECT_TRUE(misplaced_mass(meeting(true)).empty());
  EXPECT_TRUE(misplaced_mass(two_legs(0.0, 0.0)).empty());
}

// Two that end in each other weigh what they did, as a cube about the crossing:
// M about it is that of the cube and of legs that begin at its faces.
TEST(CornerMass, PutABlockWhereTwoMembersEnd) {
  const Deck deck = two_legs(90.0, 0.0);
  const Deck placed = with_placed_mass(deck);
  EXPECT_NEAR(mass_of(placed), mass_of(deck), 1e-6 * mass_of(deck));
  ASSERT_EQ(placed.masses.size(), 1U);
  const PointMass& block = placed.masses[0];
  const double cube = 7850.0 * depth * depth * depth;
  EXPECT_EQ(block.grid, per_leg + 1);
  EXPECT_NEAR(block.mass, cube, 1e-9);
  EXPECT_LT(
      (block.inertia - cube * depth * depth / 6.0 * Eigen::Matrix3d::Identity())
          .norm(),
      1e-9 * cube * depth * depth);
  EXPECT_TRUE(block.offset.isZero());
}

// Two legs that a bar shorter than its corners joins: both of its ends want all
// of it, and get what there is.
TEST(CornerMass, GivesABarBetweenTwoCornersNoMoreThanItHas) {
  std::string text =
      "BEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,.1,0.,0.\n"
      "GRID,3,,.1,.015,0.\nGRID,4,,0.,.015,0.\n"
      "CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\n"
      "CBAR,3,1,3,4,0.,0.,1.\n";
  text += fmt::format(
      "PBAR,1,1,{0},{1},{1},2e-8\n", depth * depth, std::pow(depth, 4) / 12.0);
  const Deck deck = deck_of(text + "MAT1,1,2.1+11,,.3,7850.\nENDDATA\n");
  const Deck placed = with_placed_mass(deck);
  ASSERT_EQ(placed.masses.size(), 2U);
  EXPECT_GT(placed.masses[0].mass, 0.0);
  EXPECT_NEAR(mass_of(placed), mass_of(deck), 1e-9 * mass_of(deck));
}

}  // namespace
}  // namespace tapfit::structure
