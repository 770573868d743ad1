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
