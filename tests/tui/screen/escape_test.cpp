// What Esc leaves, and in which order.
#include "tests/tui/support/play.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

constexpr Canvas canvas{120, 35, false};

struct View {
  const char* keys;  ///< that lead to it
  const char* holds;
};

void PrintTo(const View& view, std::ostream* to) { *to << view.keys; }

class EscapeTest : public ::testing::TestWithParam<View> {};

TEST_P(EscapeTest, LeavesAViewForTheScreensMainOne) {
  const std::string screen(GetParam().keys, 1);
  const std::string keys(GetParam().keys + 1);
  const std::string main = played(screen + "\nwait", canvas);
  const std::string view =
      played(fmt::format("{}\nwait\n{}\nwait", screen, keys), canvas);
  EXPECT_FALSE(holds(main, GetParam().holds)) << main;
  EXPECT_TRUE(holds(view, GetParam().holds)) << view;
  EXPECT_EQ(played(fmt::format("{}\nwait\n{}\nwait\n<Esc>\nwait", screen, keys),
                   canvas),
            main);
  EXPECT_TRUE(holds(
      played(
          fmt::format("{}\nwait\n{}\nwait\n<Esc>\nwait\n<Esc>", screen, keys),
          canvas),
      "q quits"));
}

INSTANTIATE_TEST_SUITE_P(
    Views,
    EscapeTest,
    ::testing::Values(View{"2d", "driving point"},
                      View{"2<Tab>", "  coherence"},
                      View{"2<Tab><Tab><Tab>", "Im H"},
                      View{"3m", "MAC in %"},
                      View{"4<Tab><Tab><Tab>", "MAC in %"},
                      View{"5m", "alone explain:"},
                      View{"6<Tab>", "nothing was added yet"},
                      View{"6<Tab><Tab>", "nothing was identified yet"}));

TEST(Escape, LeavesTheZoomOnAHit) {
  const std::string main = played("1\nwait\n", canvas);
  EXPECT_NE(played("1\nwait\n<Enter>", canvas), main);
  EXPECT_EQ(played("1\nwait\n<Enter><Esc>", canvas), main);
  EXPECT_EQ(played("1\nwait\ni<Esc>", canvas), main);
}

// What lies on top goes first.
TEST(Escape, LeavesAFilterThenAViewThenTheScreen) {
  const std::string there = "4\nwait\n<Enter>\nwait\nd\nwait\n/zz<Enter>";
  const auto after = [&](int escapes) {
    std::string script = there;
    for (int i = 0; i < escapes; ++i) script += "\n<Esc>\nwait";
    return played(script, canvas);
  };
  EXPECT_TRUE(holds(after(0), "filter /zz")) << after(0);
  EXPECT_FALSE(holds(after(1), "filter /zz")) << after(1);
  EXPECT_TRUE(holds(after(1), "driving point")) << after(1);
  EXPECT_FALSE(holds(after(2), "driving point")) << after(2);
  EXPECT_TRUE(holds(after(2), "Compare > FRF (Esc back)")) << after(2);
  EXPECT_TRUE(holds(after(3), "error 38.8 %")) << after(3);
  EXPECT_TRUE(holds(after(4), "q quits")) << after(4);
}

TEST(Escape, LeavesAViewBeforeItStopsWorkBesideIt) {
  FakeOptions options;
  options.endless_modes = true;
  Program program(testing::fake_workbench(options), canvas);
  const auto tick_until = [&](const char* text) {
    for (int i = 0; i < 20000 && !holds(program.draw().to_text(), text); ++i) {
      program.tick();
    }
    return holds(program.draw().to_text(), text);
  };
  program.press(Key(U'2'));
  ASSERT_TRUE(tick_until("|H|"));
  wait_until_idle(program);
  program.press(Key(U'3'));
  ASSERT_TRUE(tick_until("43 %"));
  program.press(Key(U'2'));
  program.press(Key(U'd'));
  program.press(Key(keys::escape));
  EXPECT_FALSE(holds(program.draw().to_text(), "driving point"));
  EXPECT_FALSE(holds(program.draw().to_text(), "stopping"));
  program.press(Key(keys::escape));
  EXPECT_TRUE(holds(program.draw().to_text(), "stopping"));
}

}  // namespace
}  // namespace tapfit::tui
