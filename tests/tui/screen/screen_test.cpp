#include "tui/screen/screen.hpp"

#include "tests/support/matchers.hpp"
#include "tui/screen/text.hpp"

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
  EXPECT_THAT(screen.to_text(), HasSubstr("1 +- 2 (m/s^2) ->"));
}

TEST(Text, TakesBrokenUtf8AsQuestionMarks) {
  const std::vector<Glyph> glyphs = decode("a\xC3(\xFF\xE2\x82");
  for (const Glyph& glyph : glyphs) EXPECT_LT(glyph.base, 0x80U);
  EXPECT_EQ(glyphs.front().base, U'a');
}

TEST(Text, DecodesWhatItEncodes) {
  for (const char32_t glyph : {U'a', U'±', U'⣿', U'…'}) {
    std::string text;
    append_utf8(text, glyph);
    ASSERT_EQ(decode(text).size(), 1U);
    EXPECT_EQ(decode(text)[0].base, glyph);
  }
}

TEST(Text, ControlCharactersNeverReachTheTerminal) {
  EXPECT_EQ(decode("\x1b[2J")[0].base, U'?');
}

TEST(Text, CountsTheCellsOfWideGlyphsAndAccents) {
  EXPECT_EQ(text_width("橋梁 1"), 6);
  EXPECT_EQ(text_width("다리"), 4);
  EXPECT_EQ(text_width("🔨!"), 3);
  EXPECT_EQ(text_width("e\u0301tude"), 5);
  // A sign of direction, a joiner and a sign of the variant show nothing.
  EXPECT_EQ(text_width("a\u202Eb\u200Dc\uFE0F"), 3);
  EXPECT_EQ(decode("a\u202Eb").size(), 2U);
  EXPECT_EQ(decode("e\u0301")[0].mark, U'\u0301');
}

TEST(Text, CutsBetweenWideGlyphs) {
  EXPECT_EQ(clipped("橋梁の試験", 10), "橋梁の試験");
  EXPECT_EQ(clipped("橋梁の試験", 9), "橋梁の試…");
  EXPECT_EQ(clipped("橋梁の試験", 8), "橋梁の…");
  EXPECT_EQ(text_width(clipped("橋梁の試験", 8)), 7);
  EXPECT_EQ(wrapped("橋梁 試験", 5),
            (std::vector<std::string>{"橋梁", "試験"}));
}

TEST(Screen, GivesWideGlyphsTwoCells) {
  Screen screen(8, 1);
  EXPECT_EQ(screen.text(0, 0, "a橋e\u0301z"), 5);
  EXPECT_EQ(screen.to_text(), "a橋e\u0301z\n");
  EXPECT_EQ(screen.at(2, 0).glyph, U'\0');
  EXPECT_EQ(screen.at(4, 0).glyph, U'z');
  Screen larger(10, 1);
  larger.place(1, 0, screen);
  EXPECT_EQ(larger.to_text(), " a橋e\u0301z\n");
  // There is no half of one, wherever it is written over.
  screen.put(2, 0, U'|');
  EXPECT_EQ(screen.to_text(), "a |e\u0301z\n");
  screen.text(1, 0, "橋");
  screen.put(1, 0, U'|');
  EXPECT_EQ(screen.to_text(), "a| e\u0301z\n");
  Screen narrow(2, 1);
  narrow.text(1, 0, "橋");
  EXPECT_EQ(narrow.to_text(), "\n");
}

TEST(Screen, ShowsWideGlyphsAsQuestionMarksInAscii) {
  Screen screen(8, 1, true);
  screen.text(0, 0, "a橋e\u0301");
  EXPECT_EQ(screen.to_text(), "a?e\n");
}

TEST(Text, WrapsAtSpaces) {
  const std::vector<std::string> lines = wrapped("one two three", 7);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "one two");
  EXPECT_EQ(lines[1], "three");
}

}  // namespace
}  // namespace tapfit::tui
