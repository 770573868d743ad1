// What terminals answer of their graphics, and what was typed meanwhile.
#include "tui/screen/graphics_question.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(GraphicsQuestion, AsksKittysOnlyWhereItIsNotPrinted) {
  const std::string of_kitty = "\033_G";
  EXPECT_TRUE(graphics_question("xterm-kitty").starts_with(of_kitty));
  EXPECT_TRUE(graphics_question("xterm-256color").starts_with(of_kitty));
  for (const char* kind :
       {"linux", "vt100", "screen-256color", "tmux-256color"}) {
    EXPECT_EQ(graphics_question(kind), "\033[16t\033[c") << kind;
  }
  EXPECT_EQ(graphics_question("dumb"), "");
  EXPECT_EQ(graphics_question(""), "");
}

TEST(GraphicsQuestion, IsAnsweredByKitty) {
  const GraphicsAnswer answer =
      read_graphics_answer("\033_Gi=31;OK\033\\\033[6;20;10t\033[?62;c");
  EXPECT_TRUE(answer.complete && answer.kitty);
  EXPECT_FALSE(answer.sixel);
  EXPECT_EQ(answer.cell, (CellPixels{10, 20}));
  EXPECT_EQ(answer.typed, "");
}

TEST(GraphicsQuestion, IsAnsweredByWhatHasSixels) {
  EXPECT_TRUE(read_graphics_answer("\033[?62;4;22c").sixel);
  EXPECT_TRUE(read_graphics_answer("\033[?63;1;2;4c").sixel);
  // VT132's own number is 4.
  EXPECT_FALSE(read_graphics_answer("\033[?4;6c").sixel);
  EXPECT_FALSE(read_graphics_answer("\033[?62;14;40c").sixel);
  EXPECT_FALSE(
      read_graphics_answer("\033_Gi=31;ENOTSUP:no\033\\\033[?6c").kitty);
}

TEST(GraphicsQuestion, IsNotCompleteBeforeTheLastAnswer) {
  const std::string all = "\033_Gi=31;OK\033\\\033[6;20;10t\033[?62;4c";
  for (std::size_t n = 0; n < all.size(); ++n) {
    EXPECT_FALSE(read_graphics_answer(all.substr(0, n)).complete) << n;
  }
  EXPECT_TRUE(read_graphics_answer(all).complete);
}

TEST(GraphicsQuestion, KeepsWhatWasTyped) {
  const GraphicsAnswer answer = read_graphics_answer(
      "2\033[B\033_Gi=31;OK\033\\\xC3\xA4q\033[6;20;10t\033[?62;4c\033");
  EXPECT_TRUE(answer.complete && answer.kitty && answer.sixel);
  EXPECT_EQ(answer.typed, "2\033[B\xC3\xA4q\033");
}

}  // namespace
}  // namespace tapfit::tui
