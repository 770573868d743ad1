#include "tests/tui/play.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

// What was found stays to be read until something else is.
TEST(Program, KeepsTheLastListWhileItLooksAnew) {
  FakeOptions options;
  options.endless_diagnosis = true;
  Program program(testing::fake_workbench(options), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait\n"));
  program.press(Key(U'5'));
  const auto seen = [&program] { return program.draw().to_text(); };
  for (int i = 0; i < 20000 && !holds(seen(), "43 %"); ++i) program.tick();
  EXPECT_TRUE(holds(seen(), "hypotheses … 43 %")) << seen();
  EXPECT_TRUE(holds(seen(), "verdict: added-mass")) << seen();
  EXPECT_TRUE(holds(seen(), "as of before the last change")) << seen();
  // It may be read, but what it proposes is not added.
  program.press(Key(U'j'));
  EXPECT_TRUE(holds(seen(), "▸    1.7 %")) << seen();
  program.press(Key(U'a'));
  EXPECT_TRUE(holds(seen(), "found before the last change")) << seen();
  program.press(Key(keys::escape));
  wait_until_idle(program);
  EXPECT_TRUE(holds(seen(), "as of before the last change")) << seen();
}

TEST(Program, ShowsTheNewListOnceItIsThere) {
  const std::string text = played("5\nwait\na\nwait\n5\nwait");
  EXPECT_FALSE(holds(text, "as of before")) << text;
}

}  // namespace
}  // namespace tapfit::tui
