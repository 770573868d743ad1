#include "updating/places/support_axes.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/places/support_groups.hpp"
#include "updating/places/support_line.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tapfit::updating {
namespace {

// A plate of 1 m, simply supported all around: in its plane held everywhere.
structure::Deck plate_in_its_plane() {
  structure::Deck deck = structure::plate_deck({}, 8, 8);
  for (const structure::Grid& grid : deck.grids) {
    deck.constraints.push_back({grid.id, "126"});
    const double x = grid.position.x();
    const double y = grid.position.y();
    if (std::min({x, y, 1.0 - x, 1.0 - y}) < 1e-9) {
      deck.constraints.push_back({grid.id, "3"});
    }
  }
  return deck;
}

TEST(SupportAxes, WhatIsHeldEverywhereIsNoSupport) {
  const structure::Deck deck = plate_in_its_plane();
  const SupportAxes supports = support_axes(deck);
  EXPECT_EQ(supports.everywhere, "126");
  EXPECT_EQ(supports.axes.held.size(), 32U);
  EXPECT_EQ(supports.axes.held.at(1), "3");
  const auto groups = support_groups(deck);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups.front().size(), 32U);
  const SupportLine line = support_line(deck, groups.front(), false);
  EXPECT_NEAR(line.length, 4.0, 1e-9);
  for (const SupportDof& dof : line.dofs) EXPECT_EQ(dof.component, 3);
  EXPECT_TRUE(support_line(deck, groups.front(), true).dofs.empty());
}

TEST(SupportAxes, ClampIsWhatItIs) {
  structure::Deck deck = structure::plate_deck({}, 8, 8);
  for (int k = 1; k <= 9; ++k) deck.constraints.push_back({k, "123456"});
  const SupportAxes supports = support_axes(deck);
  EXPECT_EQ(supports.everywhere, "");
  EXPECT_EQ(supports.axes.held.size(), 9U);
}

}  // namespace
}  // namespace tapfit::updating
