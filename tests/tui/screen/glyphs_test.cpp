#include "tui/screen/glyphs.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(Glyphs, BlocksAreFilledWhereADotIs) {
  EXPECT_EQ(block_glyph(0x2800), U' ');
  EXPECT_EQ(block_glyph(0x28FF), U'█');
  // Dots 1 to 8 of Unicode's numbering, one at a time.
  EXPECT_EQ(block_glyph(0x2801), U'▘');
  EXPECT_EQ(block_glyph(0x2802), U'▘');
  EXPECT_EQ(block_glyph(0x2804), U'▖');
  EXPECT_EQ(block_glyph(0x2808), U'▝');
  EXPECT_EQ(block_glyph(0x2810), U'▝');
  EXPECT_EQ(block_glyph(0x2820), U'▗');
  EXPECT_EQ(block_glyph(0x2840), U'▖');
  EXPECT_EQ(block_glyph(0x2880), U'▗');
  EXPECT_EQ(block_glyph(U'⡇'), U'▌');
  EXPECT_EQ(block_glyph(U'⠉'), U'▀');
  EXPECT_EQ(block_glyph(U'a'), U'a');
  EXPECT_EQ(block_glyph(U'│'), U'│');
}

TEST(Glyphs, FollowTheTerminal) {
  EXPECT_EQ(glyphs_of("xterm-256color", true), Glyphs::Braille);
  EXPECT_EQ(glyphs_of("tmux-256color", true), Glyphs::Braille);
  EXPECT_EQ(glyphs_of("linux", true), Glyphs::Blocks);
  EXPECT_EQ(glyphs_of("xterm", false), Glyphs::Ascii);
}

TEST(Glyphs, BackgroundIsLightOnlyWhereItIsSaid) {
  EXPECT_TRUE(is_light("0;15"));
  EXPECT_TRUE(is_light("0;default;15"));
  EXPECT_TRUE(is_light("0;7"));
  EXPECT_FALSE(is_light("15;0"));
  EXPECT_FALSE(is_light("7;8"));  // dark grey
  EXPECT_FALSE(is_light(""));
  EXPECT_FALSE(is_light("15"));
  EXPECT_FALSE(is_light("15;default"));
}

}  // namespace
}  // namespace tapfit::tui
