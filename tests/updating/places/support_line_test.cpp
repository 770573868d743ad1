#include "updating/places/support_line.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

// Five grids 0.03 m apart along x = 0: 1, 12, 23, 34, 45.
structure::Deck held_at(const std::vector<int>& nodes) {
  structure::Deck deck = support::plate_deck(false);
  for (const int node : nodes) deck.constraints.push_back({node, "123456"});
  return deck;
}

double length_at(const SupportLine& line, int node) {
  const auto at =
      std::find_if(line.dofs.begin(), line.dofs.end(), [node](const auto& dof) {
        return dof.node == node;
      });
  return at == line.dofs.end() ? -1.0 : at->length;
}

TEST(SupportLine, EachGridCarriesHalfTheGapsBesideIt) {
  const std::vector<int> nodes = {1, 12, 23, 34, 45};
  const SupportLine line = support_line(held_at(nodes), nodes, true);
  EXPECT_NEAR(line.length, 0.12, 1e-12);
  EXPECT_NEAR(length_at(line, 1), 0.015, 1e-12);
  EXPECT_NEAR(length_at(line, 23), 0.03, 1e-12);
  // About the line, which runs along y.
  EXPECT_EQ(line.dofs.front().component, 5);
}

TEST(SupportLine, WhatIsFreedIsAllThatIsHeldSo) {
  const std::vector<int> nodes = {1, 12, 23, 34, 45};
  const structure::Deck deck = held_at(nodes);
  const auto count = [&](const std::string& variant) {
    const std::vector<SupportPart> parts = support_parts(deck, nodes, variant);
    return parts.size() == 1 ? parts.front().line.dofs.size() : 0U;
  };
  EXPECT_EQ(count("free"), 30U);
  EXPECT_EQ(count("free-rotations"), 15U);
  EXPECT_EQ(count("free-X"), 5U);
  structure::Deck pinned = support::plate_deck(false);
  pinned.constraints.push_back({1, "3"});
  EXPECT_TRUE(support_parts(pinned, {1}, "free-X").empty());
}

// Clamped along x = 0 and along y = 0.
TEST(SupportLine, EdgesAroundACornerTurnEachAboutItself) {
  const std::vector<int> nodes = {
      1, 12, 23, 34, 45, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const structure::Deck deck = held_at(nodes);
  const SupportLine line = support_line(deck, nodes, true);
  EXPECT_NEAR(line.length, 0.42, 1e-12);
  EXPECT_FALSE(line.straight);
  EXPECT_EQ(line.dofs.size(), 16U);
  double about[2] = {0.0, 0.0};
  for (const SupportDof& dof : line.dofs) {
    ASSERT_TRUE(dof.component == 4 || dof.component == 5);
    about[dof.component - 4] += dof.length;
  }
  EXPECT_NEAR(about[0], 0.30, 1e-12);
  EXPECT_NEAR(about[1], 0.12, 1e-12);
  const SupportLine shifts = support_line(deck, nodes, false);
  EXPECT_EQ(shifts.dofs.size(), 45U);
  EXPECT_NEAR(length_at(shifts, 1), 0.03, 1e-12);  // half of either edge
  EXPECT_NEAR(length_at(shifts, 11), 0.015, 1e-12);
  const std::vector<SupportPart> face = support_parts(deck, nodes, "face");
  ASSERT_EQ(face.size(), 1U);
  EXPECT_NEAR(face.front().line.length, 0.42, 1e-12);
  EXPECT_NEAR(face.front().turn, 0.42 * std::pow(0.003, 3) / 12.0, 1e-18);
}

// Two clamps of 0.03 m with nothing held between them.
TEST(SupportLine, TheGapBetweenTwoEdgesCarriesNothing) {
  const std::vector<int> nodes = {1, 12, 34, 45};
  const SupportLine line = support_line(held_at(nodes), nodes, true);
  EXPECT_NEAR(line.length, 0.06, 1e-12);
  for (const int node : nodes) EXPECT_NEAR(length_at(line, node), 0.015, 1e-12);
}

// Bolts: no two are joined by an edge, so the gaps are all there is.
TEST(SupportLine, GridsAloneStandForTheGapsBesideThem) {
  const std::vector<int> nodes = {1, 23, 45};
  const SupportLine line = support_line(held_at(nodes), nodes, true);
  EXPECT_NEAR(line.length, 0.12, 1e-12);
  EXPECT_NEAR(length_at(line, 23), 0.06, 1e-12);
}

// A portal's feet stand on a line, too, but turn about no line.
TEST(SupportLine, FeetOfAFrameTurnEachByItself) {
  const structure::Deck deck = structure::deck_of(
      "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,1.-4,1.-9,1.-9,1.-9\n"
      "GRID,1,,0.,0.,0.\nGRID,2,,0.,0.,1.\n"
      "GRID,3,,2.,0.,1.\nGRID,4,,2.,0.,0.\n"
      "CBAR,1,1,1,2,0.,1.,0.\nCBAR,2,1,2,3,0.,1.,0.\n"
      "CBAR,3,1,3,4,0.,1.,0.\nSPC1,1,123456,1,4\n");
  const SupportLine both = support_line(deck, {1, 4}, true);
  ASSERT_EQ(both.dofs.size(), 6U);
  EXPECT_FALSE(both.straight);
  EXPECT_DOUBLE_EQ(both.length, 2.0);
  const SupportLine one = support_line(deck, {1}, true);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(both.dofs[k].component, one.dofs[k].component);
    EXPECT_DOUBLE_EQ(both.dofs[k].length, one.dofs[k].length);
  }
}

// Each turns about itself.
TEST(SupportLine, EdgesAcrossFromEachOtherAreEachALine) {
  const std::vector<int> nodes = {1, 12, 23, 34, 45, 11, 22, 33, 44, 55};
  const SupportLine line = support_line(held_at(nodes), nodes, true);
  EXPECT_NEAR(line.length, 0.24, 1e-12);
  ASSERT_EQ(line.dofs.size(), 10U);
  for (const SupportDof& dof : line.dofs) EXPECT_EQ(dof.component, 5);
}

// What goes with the stiffness at one end and at the other is the whole line;
// a moment of the shares about an end tells which is which.
TEST(SupportLine, SharesOfItsEndsAddUpToTheLine) {
  const std::vector<int> nodes = {45, 1, 12, 23, 34};
  const structure::Deck deck = held_at(nodes);
  const SupportLine whole = support_line(deck, nodes, true);
  const auto parts = support_parts(deck, nodes, "rotation-varying");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].end, 1);
  EXPECT_EQ(parts[1].end, 45);
  EXPECT_NEAR(parts[0].line.length, 0.06, 1e-12);
  EXPECT_NEAR(parts[1].line.length, 0.06, 1e-12);
  // Half way along the two are alike, a quarter of the way one has 3/4.
  EXPECT_NEAR(length_at(parts[0].line, 23), 0.015, 1e-12);
  EXPECT_NEAR(length_at(parts[0].line, 12), 0.75 * 0.03, 1e-12);
  EXPECT_NEAR(length_at(parts[1].line, 12), 0.25 * 0.03, 1e-12);
  EXPECT_NEAR(length_at(parts[0].line, 1), length_at(whole, 1), 1e-12);
  EXPECT_EQ(length_at(parts[1].line, 1), -1.0);
  // One grid, or bolts round a circle, have no ends.
  EXPECT_TRUE(support_parts(deck, {1}, "rotation-varying").empty());
}

}  // namespace
}  // namespace tapfit::updating
