#include "tui/screen.hpp"

#include "tui/text.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(Screen, WritesTextAndDropsWhatIsOutside) {
  Screen screen(6, 2);
  EXPECT_EQ(screen.text(4, 0, "abc"), 7);
  screen.put(-1, 0, U'x');
  screen.put(0, 2, U'x');
  EXPECT_EQ(screen.to_text(), "    ab\n\n");
}

TEST(Screen, CutsTextWithAMark) {
  Screen screen(10, 1);
  screen.text(0, 0, "abcdef", {}, 4);
  EXPECT_EQ(screen.to_text(), "abc…\n");
}

TEST(Screen, HoldsOnlyAsciiWhenAskedTo) {
  Screen screen(20, 3, true);
  screen.box({0, 0, 20, 3}, "a±b");
  screen.text(1, 1, "1 ± 2 (m/s²) → █ 漢");
  for (const char c : screen.to_text()) {
    EXPECT_LT(static_cast<unsigned char>(c), 0x80U);
  }
  EXPECT_NE(screen.to_text().find("1 +- 2 (m/s^2) ->"), std::string::npos);
}

TEST(Text, TakesBrokenUtf8AsQuestionMarks) {
  const std::vector<char32_t> glyphs = decode("a\xC3(\xFF\xE2\x82");
  for (const char32_t glyph : glyphs) EXPECT_LT(glyph, 0x80U);
  EXPECT_EQ(glyphs.front(), U'a');
}

TEST(Text, DecodesWhatItEncodes) {
  for (const char32_t glyph : {U'a', U'±', U'⣿', U'…'}) {
    std::string text;
    append_utf8(text, glyph);
    ASSERT_EQ(decode(text).size(), 1U);
    EXPECT_EQ(decode(text)[0], glyph);
  }
}

TEST(Text, ControlCharactersNeverReachTheTerminal) {
  EXPECT_EQ(decode("\x1b[2J")[0], U'?');
}

TEST(Text, WrapsAtSpaces) {
  const std::vector<std::string> lines = wrapped("one two three", 7);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "one two");
  EXPECT_EQ(lines[1], "three");
}

}  // namespace
}  // namespace tapfit::tui
