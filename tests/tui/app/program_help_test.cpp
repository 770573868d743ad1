#include "tests/tui/support/play.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(Program, HelpNamesTheKeysOfTheScreen) {
  const std::string text = played("5\nwait\n?", {120, 40, false});
  EXPECT_TRUE(holds(text, "add it")) << text;
  EXPECT_TRUE(holds(text, ":      commands")) << text;
  EXPECT_FALSE(holds(played("5\nwait\n?x"), "commands"));
}

// A long entry that does not fit gives its room to those behind it.
TEST(Program, KeyBarIsFilled) {
  const std::string text = played("wait");
  EXPECT_TRUE(holds(text, "n p run  Enter zoom")) << text;
  EXPECT_TRUE(holds(played("2\nwait\nd"), "d back to FRFs  j k check"));
}

TEST(Program, TheKeyThatClosesTheHelpDoesNothingElse) {
  const std::string text = played("3\nwait\n?x\nwait");
  EXPECT_FALSE(holds(text, "dropped")) << text;
  EXPECT_TRUE(holds(text, "3 modes")) << text;
  // Nor do those that lead elsewhere.
  for (const char* key : {"6", ":", "j", "n", "q"}) {
    EXPECT_EQ(played(fmt::format("3\nwait\n?{}\nwait", key), {120, 40, false}),
              played("3\nwait", {120, 40, false}))
        << key;
  }
}

TEST(Program, HelpOffersAFilterOnlyWhereThereIsAList) {
  EXPECT_FALSE(holds(played("7\nwait\n?"), "filter the list"));
  EXPECT_TRUE(holds(played("2\nwait\n?"), "filter")) << played("2\nwait\n?");
}

// On the smallest screen some helps are longer than the screen.
TEST(Program, HelpScrollsToItsEnd) {
  const std::string first = played("5\nwait\n?");
  EXPECT_TRUE(holds(first, "j k scroll")) << first;
  EXPECT_TRUE(holds(first, "↓ more")) << first;
  EXPECT_FALSE(holds(first, "^Z")) << first;
  for (const char* down :
       {"jjjjjjjj", "<PageDown>", "<Down><Down><Down><Down><Down>"}) {
    const std::string last = played(fmt::format("5\nwait\n?{}", down));
    EXPECT_TRUE(holds(last, "^Z")) << last;
    EXPECT_TRUE(holds(last, "↑ more")) << last;
    EXPECT_FALSE(holds(last, "↓ more")) << last;
  }
  EXPECT_EQ(played("5\nwait\n?jjjj<PageUp>"), first);
  EXPECT_EQ(played("5\nwait\n?jjjjx"), played("5\nwait"));
  // Where all of it fits there is nothing to scroll: any key closes.
  EXPECT_EQ(played("5\nwait\n?j", {120, 40, false}),
            played("5\nwait", {120, 40, false}));
}

}  // namespace
}  // namespace tapfit::tui
