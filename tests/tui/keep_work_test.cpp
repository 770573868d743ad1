#include "tui/keep_work.hpp"

#include "tests/tui/play.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(KeepWork, NotesWhetherItFailed) {
  FakeOptions full;
  full.unsaved = "no space is left";
  Snapshot known;
  EXPECT_EQ(keep_work(*testing::fake_workbench(full), known, {}, "added"),
            "added; no space is left");
  EXPECT_TRUE(known.unsaved);
  EXPECT_EQ(keep_work(*testing::fake_workbench(full), known, {}, ""),
            "no space is left");
  EXPECT_EQ(keep_work(*testing::fake_workbench(), known, {}, "added"), "added");
  EXPECT_FALSE(known.unsaved);
}

TEST(KeepWork, LeavingAsksOnceWhereWorkWouldBeLost) {
  FakeOptions full;
  full.unsaved = "no space is left";
  Program program(testing::fake_workbench(full), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait"));
  program.press(Key(U'q'));
  EXPECT_FALSE(program.quit());
  EXPECT_TRUE(holds(program.draw().to_text(), "q again leaves"));
  // Another key takes the question back.
  program.press(Key(U'j'));
  program.press(Key(U'q'));
  EXPECT_FALSE(program.quit());
  program.press(Key(U'q'));
  EXPECT_TRUE(program.quit());
}

TEST(KeepWork, LeavingAsksNothingWhereAllIsSaved) {
  Program program(testing::fake_workbench(), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait"));
  program.press(Key(U'q'));
  EXPECT_TRUE(program.quit());
}

TEST(KeepWork, LeavingByCommandAsksToo) {
  FakeOptions full;
  full.unsaved = "no space is left";
  Program program(testing::fake_workbench(full), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait\n:q<Enter>"));
  EXPECT_FALSE(program.quit());
  program.press(Key(U'q'));
  EXPECT_TRUE(program.quit());
}

}  // namespace
}  // namespace tapfit::tui
