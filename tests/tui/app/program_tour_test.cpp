// The words that lead a newcomer from screen to screen.
#include "tests/tui/support/play.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

const std::string begin = ":tour\n<Enter>\n";

TEST(Tour, IsOnEveryScreenAndHidesNoneOfTheKeys) {
  for (const Canvas& canvas : {Canvas{80, 24, false}, Canvas{200, 50, true}}) {
    for (int screen = 1; screen <= 7; ++screen) {
      const std::string text =
          played(fmt::format("{}{}\nwait", begin, screen), canvas);
      EXPECT_TRUE(holds(text, fmt::format("{} of 7.", screen))) << text;
      EXPECT_TRUE(holds(text, "q quit")) << text;
      expect_fits(text, canvas.width);
    }
  }
}

// What the words are about is seen, down to the axis of the lowest plot.
TEST(Tour, LeavesRoomForTheWholeScreen) {
  const std::vector<std::string> feet{"t [s]",
                                      "5.000 Hz   |H|",
                                      "f [Hz]",
                                      "s = 5 + jw, 1 to 40 Hz",
                                      "grid 5 alone explains"};
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const std::string text =
        played(fmt::format("{}{}\nwait{}", begin, i + 1, i == 1 ? "\nn" : ""));
    EXPECT_TRUE(holds(text, feet[i])) << text;
    EXPECT_TRUE(holds(text, fmt::format("{} of 7.", i + 1))) << text;
  }
}

TEST(Tour, SaysWhereToGoOn) {
  for (int screen = 1; screen <= 4; ++screen) {
    const std::string text = played(fmt::format("{}{}\nwait", begin, screen));
    EXPECT_TRUE(holds(text, fmt::format("Then {}.", screen + 1))) << text;
  }
}

TEST(Tour, FollowsTheWork) {
  EXPECT_TRUE(holds(played(begin + "5\nwait"), "Now A: it adds all"));
  EXPECT_TRUE(holds(played(begin + "6\nwait"), "Nothing is yet"));
  EXPECT_TRUE(
      holds(played(begin + "5\nwait\nA\nwait"), "6 of 7. The effects are in"));
}

TEST(Tour, EndsWhereItIsTypedAgainAndIsNotThereUnasked) {
  EXPECT_FALSE(holds(played("1\nwait"), "1 of 7."));
  EXPECT_FALSE(holds(played(begin + begin + "1\nwait"), "1 of 7."));
}

TEST(Tour, KnowsThatATestMayComeWithoutRecordings) {
  FakeOptions options;
  options.ready_frfs = true;
  const std::string text = played(begin + "1\nwait", {}, options);
  EXPECT_TRUE(holds(text, "came without recordings")) << text;
}

TEST(Tour, GivesWayToTheHelp) {
  const std::string text = played(begin + "1\nwait\n?\n");
  EXPECT_FALSE(holds(text, "1 of 7.")) << text;
}

}  // namespace
}  // namespace tapfit::tui
