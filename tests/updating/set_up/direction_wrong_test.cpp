#include "updating/set_up/direction_wrong.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/sheet_edits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::effects {
namespace {

class Directions : public ::testing::Test {
 protected:
  [[nodiscard]] bool tries(const std::vector<std::string>& channels,
                           int grid,
                           const std::string& direction) const {
    Where where;
    where.channels = channels;
    if (grid != 0) where.nodes = {grid};
    where.variant = direction;
    const std::vector<Where> all =
        DirectionWrong().places(support::plate_setting(bundle_, deck_));
    return std::ranges::find(all, where) != all.end();
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
};

TEST_F(Directions, AreAllOthersOfAChannel) {
  EXPECT_TRUE(tries({"acc1"}, 0, "+X"));
  EXPECT_TRUE(tries({"acc1"}, 0, "-Y"));
  EXPECT_TRUE(tries({"hammer"}, 0, "+X"));
  EXPECT_TRUE(tries({"acc1", "acc2"}, 0, "+X"));
  EXPECT_FALSE(tries({"acc1"}, 0, "+Z")) << "as written";
  EXPECT_FALSE(tries({"acc1"}, 0, "-Z")) << "its polarity";
}

TEST_F(Directions, TurnRoundAtOnePointOfAChannelThatMoves) {
  EXPECT_TRUE(tries({"hammer"}, 28, "-Z"));
  EXPECT_TRUE(tries({"hammer"}, 28, "+X"));
  EXPECT_FALSE(tries({"hammer"}, 28, "+Z"));
  EXPECT_FALSE(tries({"acc1"}, 11, "+X")) << "its only point: the channel's";
}

TEST_F(Directions, AreCorrectedOnTheSheet) {
  Where where;
  where.channels = {"acc2"};
  where.variant = "+X";
  EXPECT_EQ(sheet_edits(DirectionWrong(), where, bundle_, bundle_),
            std::vector<std::string>{"runs[0-5].sensors[1].direction: -Z -> "
                                     "+X"});
}

}  // namespace
}  // namespace tapfit::effects
