// The program in terminals that have graphics: what is asked, what is drawn in
// pixels, and that nothing of it stays.
#include "tests/end_to_end/pseudo_terminal.hpp"
#include "tests/end_to_end/small_bundle.hpp"
#include "tui/screen/palette.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/wait.h>

namespace tapfit::end_to_end {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using tui::Graphics;

constexpr const char* apc = "\033_G";
constexpr const char* removal_of_all = "\033_Ga=d,d=A,q=2\033\\";

TerminalSetting with_graphics(Graphics graphics) {
  TerminalSetting setting;
  setting.graphics = graphics;
  setting.cell = {10, 20};
  setting.kind = graphics == Graphics::Kitty ? "xterm-kitty" : "xterm-256color";
  setting.window_tells_pixels = graphics == Graphics::Sixel;
  return setting;
}

bool is_near(const ShownPixel& shown, const tui::Rgb& ink) {
  // Sixels have colours in per cent.
  const auto near = [](int a, int b) { return std::abs(a - b) <= 3; };
  return shown.cover > 0 && near(shown.red, ink.red) &&
         near(shown.green, ink.green) && near(shown.blue, ink.blue);
}

/// Columns of pixels that hold some of the ink.
int columns_with(const DrawnPictures& pictures, const tui::Rgb& ink) {
  int count = 0;
  for (int x = 0; x < pictures.width(); ++x) {
    bool found = false;
    for (int y = 0; y < pictures.height() && !found; ++y) {
      found = is_near(pictures.at(x, y), ink);
    }
    count += found ? 1 : 0;
  }
  return count;
}

bool shows_braille(const PseudoTerminal& terminal) {
  // U+2801 to U+28FF begin with these two bytes.
  const std::string text = terminal.screen().text();
  for (const char* begin : {"\xE2\xA0", "\xE2\xA1", "\xE2\xA2", "\xE2\xA3"}) {
    if (text.find(begin) != std::string::npos) return true;
  }
  return false;
}

void show_frf(PseudoTerminal& terminal) {
  ASSERT_TRUE(terminal.shows("3 accepted", seconds(20)));
  terminal.type("2");
  ASSERT_TRUE(terminal.shows("|H|", seconds(20)));
}

// A screen is read while it is still being drawn.
bool comes_to_show_braille(PseudoTerminal& terminal) {
  constexpr int most = 100;
  for (int tries = 0; tries < most && !shows_braille(terminal); ++tries) {
    (void)terminal.shows("no such words", milliseconds(50));
  }
  return shows_braille(terminal);
}

class GraphicsTest : public ::testing::TestWithParam<Graphics> {};

// The FRF's curve goes through every column of its plot, which is most of the
// screen's 1000 pixels wide.
TEST_P(GraphicsTest, DrawCurvesInPixels) {
  PseudoTerminal terminal({copy_of_small_bundle().string()},
                          with_graphics(GetParam()));
  show_frf(terminal);
  ASSERT_TRUE(terminal.draws(2000, seconds(10)));
  const tui::Inks inks = tui::inks(false, tui::Theme::Default);
  const tui::Rgb& curve = inks[tui::ink_number(tui::Colour::Sky, false)];
  EXPECT_GE(columns_with(terminal.screen().pictures(), curve), 500);
  EXPECT_FALSE(shows_braille(terminal));
  terminal.type("q");
  EXPECT_TRUE(terminal.ends(seconds(10)));
}

TEST_P(GraphicsTest, GoWhereTheScreenGoes) {
  PseudoTerminal terminal({copy_of_small_bundle().string()},
                          with_graphics(GetParam()));
  show_frf(terminal);
  ASSERT_TRUE(terminal.draws(2000, seconds(10)));
  const int all = terminal.screen().pictures().drawn_pixels();
  terminal.type("?");
  ASSERT_TRUE(terminal.shows("any key closes", seconds(5)));
  EXPECT_TRUE(terminal.draws_at_most(0, seconds(5)));
  terminal.type("x");
  EXPECT_TRUE(terminal.draws(all, seconds(5)));
  terminal.resize(110, 32);
  EXPECT_TRUE(terminal.draws(2000, seconds(5)));
  terminal.type("7");
  EXPECT_TRUE(terminal.draws_at_most(0, seconds(5)));
  terminal.type("2");
  EXPECT_TRUE(terminal.draws(2000, seconds(5)));
  terminal.type("\032");
  ASSERT_TRUE(terminal.stops(seconds(5)));
  EXPECT_TRUE(terminal.draws_at_most(0, seconds(1)));
  terminal.resume();
  EXPECT_TRUE(terminal.draws(2000, seconds(5)));
  // Stopped by another program, which may have written on the terminal.
  terminal.send(SIGSTOP);
  ASSERT_TRUE(terminal.stops(seconds(5)));
  const char* begin = GetParam() == Graphics::Kitty ? apc : "\033P0;1;0q";
  const std::size_t before = terminal.bytes();
  terminal.resume();
  EXPECT_TRUE(terminal.wrote_since(before, begin, seconds(5)));
  EXPECT_TRUE(terminal.draws(2000, seconds(5)));
  terminal.type("q");
  ASSERT_TRUE(terminal.ends(seconds(10)));
  EXPECT_TRUE(terminal.draws_at_most(0, seconds(1)));
}

INSTANTIATE_TEST_SUITE_P(Each,
                         GraphicsTest,
                         ::testing::Values(Graphics::Kitty, Graphics::Sixel));

TEST(Graphics, AreTakenAwayByACrash) {
  PseudoTerminal terminal({copy_of_small_bundle().string()},
                          with_graphics(Graphics::Kitty));
  show_frf(terminal);
  ASSERT_TRUE(terminal.draws(2000, seconds(10)));
  terminal.send(SIGSEGV);
  ASSERT_TRUE(terminal.ends(seconds(10)));
  EXPECT_TRUE(terminal.wrote(removal_of_all, seconds(1)));
}

TEST(Graphics, AreBrailleDotsWhereThereAreNoneAndWhereTheyAreOff) {
  PseudoTerminal without({copy_of_small_bundle().string()});
  show_frf(without);
  EXPECT_TRUE(comes_to_show_braille(without));
  PseudoTerminal off({copy_of_small_bundle().string(), "--graphics", "off"},
                     with_graphics(Graphics::Kitty));
  show_frf(off);
  EXPECT_TRUE(comes_to_show_braille(off));
  EXPECT_FALSE(off.wrote(apc, milliseconds(100)));
}

TEST(Graphics, AreNotAskedForInKittysWayOnTheLinuxConsole) {
  TerminalSetting setting;
  setting.kind = "linux";
  PseudoTerminal terminal({copy_of_small_bundle().string()}, setting);
  ASSERT_TRUE(terminal.wrote("3 accepted", seconds(20)));
  EXPECT_FALSE(terminal.wrote(apc, milliseconds(100)));
}

TEST(Graphics, LoseNoKeyThatIsTypedAhead) {
  for (const bool answers : {true, false}) {
    TerminalSetting setting = with_graphics(Graphics::Kitty);
    setting.answers = answers;
    PseudoTerminal terminal({copy_of_small_bundle().string()}, setting);
    terminal.type("2:add");
    EXPECT_TRUE(terminal.shows("\n:add", seconds(20))) << answers;
  }
}

TEST(Graphics, CostLittleWhereTheTerminalNeverAnswers) {
  TerminalSetting setting;
  setting.answers = false;
  double best = 1e9;
  for (int i = 0; i < 3; ++i) {  // the machine may be busy
    const auto start = PseudoTerminal::Clock::now();
    PseudoTerminal terminal({copy_of_small_bundle().string()}, setting);
    ASSERT_TRUE(terminal.shows("q quit", seconds(10)));
    const std::chrono::duration<double> took =
        PseudoTerminal::Clock::now() - start;
    best = std::min(best, took.count());
  }
  EXPECT_LT(best, 0.2 + 0.3);
}

}  // namespace
}  // namespace tapfit::end_to_end
