#include "updating/measurement/overruled_hit.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Hits = std::vector<OverruledHit>;

TEST(OverruledHit, WhatIsDoneTogetherIsTakenTogether) {
  Hits acts;
  add_act(acts, {{0, 1}});
  add_act(acts, {{2, 3}, {2, 4}, {5, 0}});
  Hits undone;
  add_act(undone, take_last_act(acts));
  EXPECT_EQ(acts, (Hits{{0, 1}}));
  // There and back again: the same act.
  add_act(acts, take_last_act(undone));
  EXPECT_EQ(acts, (Hits{{0, 1}, {2, 3}, {2, 4, true}, {5, 0, true}}));
  EXPECT_TRUE(undone.empty());
}

TEST(OverruledHit, NoActIsNothingToTake) {
  Hits none;
  EXPECT_TRUE(take_last_act(none).empty());
  add_act(none, {});
  EXPECT_TRUE(none.empty());
}

// As a file edited by hand may begin.
TEST(OverruledHit, AnActWithoutItsFirstHitEndsWithTheList) {
  Hits acts{{0, 1, true}, {0, 2, true}};
  EXPECT_EQ(take_last_act(acts).size(), 2U);
}

TEST(OverruledHit, TwiceIsAsBefore) {
  Hits acts;
  add_act(acts, {{0, 1}, {0, 2}});
  add_act(acts, {{0, 2}, {1, 0}});
  EXPECT_EQ(overruled_now(acts), (Hits{{0, 1}, {1, 0}}));
}

}  // namespace
}  // namespace tapfit::updating
