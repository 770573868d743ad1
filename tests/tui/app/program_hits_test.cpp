// Hits that are judged by hand.
#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(ProgramHits, OverrulesAHit) {
  EXPECT_TRUE(holds(played("wait"), "3 hits, 2 accepted"));
  const std::string text = played("wait\nj \nwait");
  EXPECT_TRUE(holds(text, "3 hits, 3 accepted")) << text;
  EXPECT_TRUE(holds(text, "#2 accepted manually (auto: double)")) << text;
}

TEST(ProgramHits, TakesTheLastOverrulingBack) {
  const std::string text = played("wait\nj \nwait\nk \nwait\nu\nwait");
  EXPECT_TRUE(holds(text, "3 hits, 3 accepted")) << text;
  EXPECT_TRUE(holds(text, "run 1, hit 1: back to automatic")) << text;
  const std::string all = played("wait\nj \nwait\nk \nwait\nuu\nwait");
  EXPECT_TRUE(holds(all, "3 hits, 2 accepted")) << all;
  EXPECT_FALSE(holds(all, "manually")) << all;
  EXPECT_TRUE(holds(played("wait\nu\nwait"), "nothing to undo"));
}

TEST(ProgramHits, RedoesAHitThatWasTakenBack) {
  const std::string text = played("wait\nj \nwait\nu\nwait\n<C-r>\nwait");
  EXPECT_TRUE(holds(text, "hit 2: judged manually again")) << text;
  EXPECT_TRUE(holds(played("wait\nj \nwait\nu\nwait\n<C-r>\nwait\n<C-r>\nwait"),
                    "nothing to redo"));
}

}  // namespace
}  // namespace tapfit::tui
