#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

// Whatever is told, it is to be read in full on the smallest screen.
TEST(Program, TellsInABoxWhatIsTooLongForTheLine) {
  FakeOptions full;
  full.unsaved = "the session cannot be saved: " + std::string(60, 'x') +
                 " (make the folder writable, or free some space)";
  const std::string script = "1\nwait\n \nwait";
  const std::string told = played(script, {}, full);
  EXPECT_TRUE(holds(told, "any key closes")) << told;
  EXPECT_TRUE(holds(told, "or free some space")) << told;
  EXPECT_FALSE(holds(told, "…\n Space accept")) << told;
  EXPECT_FALSE(holds(played(script + "\n<Esc>", {}, full), "free some space"));
  // The key that closes it does nothing else.
  for (const char* key : {"x", "2", "j", ":", "u"}) {
    EXPECT_EQ(played(script + "\n" + key + "\nwait", {}, full),
              played(script + "\n<Esc>\nwait", {}, full))
        << key;
  }
  // Where it fits the line it covers nothing.
  EXPECT_FALSE(holds(played(script, {200, 50}, full), "any key closes"));
  // A filter in force takes some of the line.
  const std::string short_one = "the session cannot be saved: no space is left";
  full.unsaved = short_one;
  EXPECT_FALSE(holds(played(script, {}, full), "any key closes"));
  const std::string filtered =
      played("1\nwait\n/double<Enter> \nwait", {}, full);
  EXPECT_TRUE(holds(filtered, short_one)) << filtered;
  EXPECT_TRUE(holds(filtered, "filter /double")) << filtered;
}

}  // namespace
}  // namespace tapfit::tui
