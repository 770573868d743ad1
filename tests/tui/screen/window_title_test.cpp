#include "tui/screen/window_title.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(WindowTitle, IsSentToWindowsAlone) {
  EXPECT_TRUE(has_window_title("xterm-256color"));
  EXPECT_TRUE(has_window_title("tmux-256color"));
  EXPECT_FALSE(has_window_title("linux"));
  EXPECT_FALSE(has_window_title("dumb"));
  EXPECT_FALSE(has_window_title(nullptr));
}

// A test's title is somebody else's, and must not end the sequence.
TEST(WindowTitle, LetsNoControlCharacterThrough) {
  EXPECT_EQ(title_sequence("plate", false), "\033]2;plate\a");
  EXPECT_EQ(title_sequence("a\a\033]52;c;x\nb", false), "\033]2;a??]52;c;xb\a");
  EXPECT_EQ(title_sequence("Pr\u00fcfung \u2265", true).find("\u2265"),
            std::string::npos);
  EXPECT_EQ(title_sequence("Prüfung", false), "\033]2;Prüfung\a");
}

}  // namespace
}  // namespace tapfit::tui
