// What the mouse does.
#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>

namespace tapfit::tui {
namespace {

Key mouse(char32_t what, int x, int y) {
  Key key(what);
  key.x = x;
  key.y = y;
  return key;
}

/// Where the text stands on the screen.
std::pair<int, int> place_of(const Program& program, const std::string& text) {
  std::istringstream lines(program.draw().to_text());
  std::string line;
  for (int y = 0; std::getline(lines, line); ++y) {
    const std::size_t at = line.find(text);
    if (at != std::string::npos) return {text_width(line.substr(0, at)), y};
  }
  return {-1, -1};
}

void click(Program& program, const std::string& text) {
  const auto [x, y] = place_of(program, text);
  ASSERT_GE(y, 0) << text << "\n" << program.draw().to_text();
  program.press(mouse(keys::click, x, y));
  wait_until_idle(program);
}

std::string seen(const Program& program) { return program.draw().to_text(); }

// Screens 4 and 5: what is most off, or most probable, first; then last.
TEST(Mouse, AClickOnAHeadingSorts) {
  for (const auto& [screen, heading] :
       {std::pair{U'4', "FRAC"}, {U'5', "hold-out error"}, {U'3', "f Hz"}}) {
    Program program(testing::fake_workbench(), {150, 40, false});
    program.press(Key(screen));
    wait_until_idle(program);
    click(program, heading);
    EXPECT_TRUE(holds(seen(program), std::string(heading) + "▾"))
        << seen(program);
    click(program, heading);
    EXPECT_TRUE(holds(seen(program), std::string(heading) + "▴"));
    click(program, heading);
    EXPECT_FALSE(holds(seen(program), std::string(heading) + "▴"));
  }
}

TEST(Mouse, ClicksMeanWhatStandsThere) {
  Program program(testing::fake_workbench(), {100, 30, false});
  wait_until_idle(program);
  click(program, "2 FRF");  // a tab
  EXPECT_TRUE(holds(seen(program), "|H|"));
  click(program, "6Z+ / 3Z+");  // a row
  EXPECT_TRUE(holds(seen(program), "▸6Z+ / 3Z+"));
  click(program, "Tab next plot");  // a key of the key bar
  EXPECT_TRUE(holds(seen(program), "coherence"));
  const auto [x, y] = place_of(program, "┤");
  // The plot: the cursor goes there.
  program.press(mouse(keys::click, x + 8, y));
  EXPECT_TRUE(holds(seen(program), "coherence 0.9")) << x << y;
  program.press(mouse(keys::click, x, 29));  // nothing there
  EXPECT_FALSE(program.quit());
}

TEST(Mouse, ClicksOnThePaletteCarryACommandOutOrTypeIt) {
  Program program(testing::fake_workbench(), {100, 40, false});
  wait_until_idle(program);
  program.press(U':');
  click(program, "words on each screen");
  EXPECT_TRUE(holds(seen(program), "1 of 7.")) << seen(program);
  EXPECT_FALSE(holds(seen(program), "command (Tab")) << seen(program);
  // One that needs a word more waits for it.
  program.press(U':');
  click(program, "shows a run of the recording");
  EXPECT_TRUE(holds(seen(program), "\n:run")) << seen(program);
  EXPECT_TRUE(holds(seen(program), "command (Tab")) << seen(program);
  program.press(U'2');
  program.press(keys::enter);
  EXPECT_TRUE(holds(seen(program), "run 2 of 2")) << seen(program);
}

// The palette's frame hides what is below it from the mouse, too.
TEST(Mouse, ChoosesNothingThroughThePalette) {
  Program program(testing::fake_workbench(), {100, 33, false});
  wait_until_idle(program);
  program.press(U'2');
  wait_until_idle(program);
  const auto [x, y] = place_of(program, "6Z+ / 4Z+");
  program.press(U':');
  ASSERT_EQ(place_of(program, "command (Tab").second, y) << seen(program);
  program.press(mouse(keys::click, x, y));
  program.press(keys::escape);
  EXPECT_TRUE(holds(seen(program), "▸6Z+ / 3Z+")) << seen(program);
}

/// The frequencies below the lowest plot of the screen, right of the list.
std::string axis(const Program& program) {
  std::istringstream lines(seen(program));
  std::string line;
  while (std::getline(lines, line)) {
    if (holds(line, "f [Hz]")) return line.substr(line.size() - 55);
  }
  return {};
}

TEST(Mouse, ShowsTheStretchThatIsDraggedOver) {
  Program program(testing::fake_workbench(), {100, 30, false});
  wait_until_idle(program);
  program.press(U'2');
  wait_until_idle(program);
  const auto [x, y] = place_of(program, "┤");
  const std::string before = axis(program);
  ASSERT_TRUE(holds(before, "30 ")) << seen(program);
  program.press(mouse(keys::click, x + 14, y));
  program.press(mouse(keys::release, x + 24, y + 2));
  const std::string after = axis(program);
  EXPECT_FALSE(holds(after, " 30 ")) << after;
  EXPECT_TRUE(holds(after, "14")) << after;
  // The other way round, and beyond the plot's edge.
  program.press(U'_');
  ASSERT_EQ(axis(program), before);
  program.press(mouse(keys::click, x + 24, y));
  program.press(mouse(keys::release, x + 14, y + 2));
  EXPECT_EQ(axis(program), after);
  program.press(U'_');
  program.press(mouse(keys::click, x + 24, y));
  program.press(mouse(keys::release, 0, y));
  EXPECT_TRUE(holds(axis(program), "5 ")) << axis(program);
  // A click that trembles, and a key between, are no drag.
  program.press(U'_');
  program.press(mouse(keys::click, x + 14, y));
  program.press(mouse(keys::release, x + 15, y));
  EXPECT_EQ(axis(program), before);
  program.press(mouse(keys::click, x + 14, y));
  program.press(U'j');
  program.press(mouse(keys::release, x + 24, y));
  EXPECT_EQ(axis(program), before);
}

// A wheel has no place where a key script turns it.
TEST(Mouse, ZoomsByTheWheelOverAPlotAndScrollsElsewhere) {
  Program program(testing::fake_workbench(), {100, 30, false});
  wait_until_idle(program);
  program.press(U'2');
  wait_until_idle(program);
  const auto [x, y] = place_of(program, "┤");
  const std::string before = axis(program);
  program.press(mouse(keys::wheel_up, x + 14, y));
  EXPECT_NE(axis(program), before);
  EXPECT_TRUE(holds(seen(program), "▸6Z+ / 3Z+")) << seen(program);
  program.press(mouse(keys::wheel_down, x + 14, y));
  EXPECT_EQ(axis(program), before);
  program.press(mouse(keys::wheel_down, 2, 3));
  EXPECT_EQ(axis(program), before);
  EXPECT_TRUE(holds(seen(program), "▸4Z+ / 3Z+")) << seen(program);
  program.press(Key(keys::wheel_down));
  EXPECT_TRUE(holds(seen(program), "▸6Z+ / 4Z+")) << seen(program);
}

TEST(Mouse, SelectsInTheMapAndTheMacWhereBothAreShown) {
  Program program(testing::fake_workbench(), {200, 50, false});
  wait_until_idle(program);
  program.press(U'4');
  wait_until_idle(program);
  const auto [x, y] = place_of(program, "MAC in %");
  ASSERT_GE(y, 0) << seen(program);
  program.press(mouse(keys::click, x + 12, y + 3));
  program.press(keys::enter);
  wait_until_idle(program);
  EXPECT_TRUE(holds(seen(program), "Compare > Modes")) << seen(program);
  program.press(keys::escape);
  click(program, " 87");
  program.press(keys::enter);
  wait_until_idle(program);
  EXPECT_TRUE(holds(seen(program), "|H| [(m/s²)/N]  6Z+ / 4Z+"))
      << seen(program);
}

}  // namespace
}  // namespace tapfit::tui
