// Two screens at once.
#include "tests/tui/support/play.hpp"
#include "tui/app/split_panes.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace tapfit::tui {
namespace {

std::vector<std::string> rows_of(const std::string& text) {
  std::vector<std::string> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  return rows;
}

constexpr Canvas wide{200, 50, false};
constexpr Canvas tall{100, 60, false};

TEST(SplitPanes, AreBothAsLargeAsAScreenHasToBe) {
  for (const auto& [width, height] :
       {std::pair{161, 21}, {162, 40}, {240, 60}, {80, 43}, {160, 50}}) {
    const auto panes = split_panes(width, height);
    ASSERT_TRUE(panes) << width << ' ' << height;
    for (const Rect& pane : {panes->first, panes->second}) {
      EXPECT_GE(pane.width, 80);
      EXPECT_GE(pane.height, 21);
    }
    const bool beside = width > 160;
    EXPECT_EQ(panes->beside, beside);
    // Nothing is left over.
    EXPECT_EQ(beside ? panes->first.width + panes->second.width + 1
                     : panes->first.height + panes->second.height + 1,
              beside ? width : height);
  }
  EXPECT_FALSE(split_panes(160, 42));
  EXPECT_FALSE(split_panes(161, 20));
  EXPECT_FALSE(split_panes(79, 100));
}

TEST(Split, ShowsTheScreenBeforeBesideThisOne) {
  const std::string text = played("2\nwait\n3\nwait\n|\nwait", wide);
  EXPECT_TRUE(holds(text, "[2 FRF]")) << text;
  EXPECT_TRUE(holds(text, "stabilisation")) << text;
  EXPECT_TRUE(holds(text, "phase [deg]")) << text;
  expect_fits(text, wide.width);
  // The keys go to the screen on the left.
  EXPECT_TRUE(holds(text, "pick pole")) << text;
  EXPECT_TRUE(holds(text, "→") || holds(text, "←"));
}

TEST(Split, IsOneAboveTheOtherWhereItIsNarrow) {
  const std::string text = played("3\nwait\n:split 2<Enter>\nwait", tall);
  const std::vector<std::string> rows = rows_of(text);
  ASSERT_EQ(rows.size(), 60U);
  EXPECT_TRUE(holds(rows[29], "──────↑")) << text;
  EXPECT_TRUE(holds(text, "stabilisation") && holds(text, "phase [deg]"));
  expect_fits(text, tall.width);
}

TEST(Split, SaysHowMuchRoomItNeeds) {
  const std::string text = played("3\nwait\n|\nwait", {120, 35, false});
  EXPECT_TRUE(holds(text,
                    "two screens need 161 x 24 cells beside each other "
                    "or 80 x 46 one above the other"))
      << text;
  EXPECT_FALSE(holds(text, "[1 Recording]"));
}

TEST(Split, WorksOutWhatBothScreensNeed) {
  Program program(testing::fake_workbench(), wide);
  program.press(U'1');
  wait_until_idle(program);
  for (const char c : std::string(":split 4\r")) {
    program.press(c == '\r' ? Key(keys::enter) : Key(static_cast<char32_t>(c)));
  }
  wait_until_idle(program);
  const std::string text = program.draw().to_text();
  EXPECT_TRUE(holds(text, "run-01.wav") && holds(text, "error 38.8 %")) << text;
}

// Each key bar has a key that the other one has not.
constexpr const char* of_frf = "next plot";
constexpr const char* of_modes = "pick pole";

std::string bar(const std::string& keys, const Canvas& canvas = wide) {
  return rows_of(played("3\nwait\n:split 2<Enter>\nwait\n" + keys, canvas))
      .back();
}

TEST(Split, GivesTheKeysToTheOtherScreenAfterCtrlW) {
  EXPECT_TRUE(holds(bar(""), of_modes));
  EXPECT_TRUE(holds(bar("<C-w>w\nwait"), of_frf));
  EXPECT_TRUE(holds(bar("<C-w><C-w>\nwait"), of_frf));
  EXPECT_TRUE(holds(bar("<C-w>w<C-w>w\nwait"), of_modes));
  EXPECT_TRUE(holds(bar("<C-w>l\nwait"), of_frf));
  EXPECT_TRUE(holds(bar("<C-w>h\nwait"), of_modes));
  EXPECT_TRUE(holds(bar("<C-w>l<C-w>h\nwait"), of_modes));
  EXPECT_TRUE(holds(bar("<C-w>j\nwait", tall), of_frf));
  // Where a screen is shown already, its number goes there.
  EXPECT_TRUE(holds(bar("2\nwait"), of_frf));
}

TEST(Split, StaysAsItIsWhereTheFocusMoves) {
  const std::string before = played("3\nwait\n:split 2<Enter>\nwait", wide);
  const std::string after =
      played("3\nwait\n:split 2<Enter>\nwait\n<C-w>w\nwait", wide);
  const std::vector<std::string> a = rows_of(before);
  const std::vector<std::string> b = rows_of(after);
  // Tabs, the arrow between and the lines below are not the same.
  EXPECT_EQ(a[3], b[3]);
  EXPECT_EQ(a[40], b[40]);
  EXPECT_TRUE(holds(b[0], "[3 Modes]")) << b[0];
}

TEST(Split, EndsWithEitherScreen) {
  const auto tabs_and_bar = [](const std::string& keys) {
    const auto rows =
        rows_of(played("3\nwait\n:split 2<Enter>\nwait\n" + keys, wide));
    return rows.front() + rows.back();
  };
  for (const char* keys : {"|\nwait",
                           ":only<Enter>\nwait",
                           "<C-w>o\nwait",
                           ":split<Enter>\nwait"}) {
    const std::string text = tabs_and_bar(keys);
    EXPECT_FALSE(holds(text, "[2 FRF]")) << keys;
    EXPECT_TRUE(holds(text, of_modes)) << keys;
  }
  for (const char* keys : {":close<Enter>\nwait", "<C-w>c\nwait"}) {
    const std::string text = tabs_and_bar(keys);
    EXPECT_FALSE(holds(text, "[3 Modes]")) << keys;
    EXPECT_TRUE(holds(text, of_frf)) << keys;
  }
}

TEST(Split, IsHiddenWhileTheWindowIsTooSmall) {
  Program program(testing::fake_workbench(), wide);
  program.press(U'3');
  wait_until_idle(program);
  program.press(U'|');
  wait_until_idle(program);
  program.resize(120, 35);
  EXPECT_TRUE(holds(program.draw().to_text(), "two screens need"));
  program.press(keys::escape);
  const std::string one = program.draw().to_text();
  EXPECT_FALSE(holds(one, "[1 Recording]")) << one;
  EXPECT_TRUE(holds(one, "stabilisation"));
  program.resize(200, 50);
  EXPECT_TRUE(holds(program.draw().to_text(), "[1 Recording]"));
}

TEST(Split, LetsScreensLeadToEachOtherAndBack) {
  // Enter on Compare opens the FRF, which is beside it.
  const std::string there =
      played("4\nwait\n:split 2<Enter>\nwait\n<Enter>\nwait", wide);
  EXPECT_TRUE(holds(there, "Compare > FRF (Esc back)")) << there;
  EXPECT_TRUE(holds(there, "[4 Compare]")) << there;
  const std::string back = played(
      "4\nwait\n:split 2<Enter>\nwait\n<Enter>\nwait\n<Esc>\nwait", wide);
  EXPECT_TRUE(holds(back, "[2 FRF]")) << back;
}

Key mouse_at(char32_t what, int x, int y) {
  Key key(what);
  key.x = x;
  key.y = y;
  return key;
}

TEST(Split, TakesClicksAndTheWheelWhereTheyAre) {
  Program program(testing::fake_workbench(), wide);
  program.press(U'2');
  wait_until_idle(program);
  program.press(U'3');
  wait_until_idle(program);
  program.press(U'|');
  wait_until_idle(program);
  const auto focused = [&] { return rows_of(program.draw().to_text()).back(); };
  EXPECT_TRUE(holds(focused(), of_modes));
  program.press(mouse_at(keys::click, 160, 10));
  EXPECT_TRUE(holds(focused(), of_frf));
  program.press(mouse_at(keys::wheel_up, 60, 40));
  EXPECT_TRUE(holds(focused(), of_modes));
  // The second row of the list on the right, whose rows are its own.
  program.press(mouse_at(keys::click, 110, 3));
  EXPECT_TRUE(holds(focused(), of_frf));
  EXPECT_TRUE(holds(rows_of(program.draw().to_text())[3], "▸"));
}

TEST(Split, HelpsWithTheScreenThatTheKeysGoTo) {
  const std::string help = played("3\nwait\n|\nwait\n?", wide);
  EXPECT_TRUE(holds(help, "other screen")) << help;
  EXPECT_TRUE(holds(help, "Modes (")) << help;
}

TEST(Split, RefusesWhatIsNoOtherScreen) {
  EXPECT_TRUE(holds(played("3\nwait\n:split 3<Enter>\nwait", wide),
                    "that screen is shown: name another"));
  EXPECT_TRUE(
      holds(played("3\nwait\n:split 9<Enter>\nwait", wide), "which screen?"));
  EXPECT_TRUE(holds(played("3\nwait\n:only<Enter>\nwait", wide),
                    "one screen is shown"));
}

}  // namespace
}  // namespace tapfit::tui
