#include "updating/places/support_groups.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Groups = std::vector<std::vector<int>>;

// Grids 1, 12, 23, 34, 45 follow each other along the edge x = 0, 11 is the far
// corner of the edge y = 0.
structure::Deck plate_held_at(const std::vector<int>& nodes) {
  structure::Deck deck = support::plate_deck(false);
  for (const int node : nodes) deck.constraints.push_back({node, "123"});
  return deck;
}

TEST(SupportGroups, AreWhatEdgesJoin) {
  EXPECT_EQ(support_groups(plate_held_at({34, 12, 45, 11, 1})),
            (Groups{{1, 12}, {11}, {34, 45}}));
}

// Grid 900 is held wholly and leads the edge x = 0, grid 23 another one.
TEST(SupportGroups, AreWhatFollowsAHeldGrid) {
  structure::Deck deck = plate_held_at({});
  for (const int id : {900, 901}) {
    structure::Grid grid = deck.grid(1);
    grid.id = id;
    deck.grids.push_back(grid);
  }
  deck.rigids.push_back({1, 23, {{901, "123456"}}});
  deck.rigids.push_back({2, 900, {{1, "123"}, {12, "12346"}, {23, "123456"}}});
  EXPECT_EQ(support_groups(deck), Groups{});
  deck.constraints.push_back({900, "12345"});
  EXPECT_EQ(support_groups(deck), (Groups{{900}}));
  deck.constraints.push_back({900, "6"});
  EXPECT_EQ(support_groups(deck), (Groups{{1, 12, 23}, {900}, {901}}));
  EXPECT_TRUE(are_hubs(deck, {900}));
  EXPECT_FALSE(are_hubs(deck, {901}));
  EXPECT_FALSE(are_hubs(deck, {1, 900}));
  EXPECT_EQ(support_choices(deck),
            (Groups{{1, 12, 23}, {900}, {901}, {1, 12, 23, 901}}));
}

TEST(SupportGroups, AreWhatSolidsJoin) {
  structure::Deck deck;
  for (int id = 1; id <= 12; ++id) {
    structure::Grid grid;
    grid.id = id;
    deck.grids.push_back(grid);
  }
  deck.solids.push_back({1, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
  deck.solids.push_back({2, 1, {5, 6, 7, 8, 9, 10, 11, 12}});
  for (const int node : {1, 4, 11, 10}) {
    deck.constraints.push_back({node, "123"});
  }
  EXPECT_EQ(support_groups(deck), (Groups{{1, 4}, {10, 11}}));
}

TEST(SupportChoices, HaveAllOfSeveralBehindThem) {
  EXPECT_EQ(support_choices(plate_held_at({1, 12, 11, 34})),
            (Groups{{1, 12}, {11}, {34}, {1, 12, 11, 34}}));
}

TEST(SupportChoices, HaveOneSupportOnce) {
  EXPECT_EQ(support_choices(plate_held_at({1, 12})), (Groups{{1, 12}}));
  EXPECT_EQ(support_choices(plate_held_at({})), Groups{});
}

}  // namespace
}  // namespace tapfit::updating
