#include "tui/widgets/level_marks.hpp"

#include "tui/screen/text.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tapfit::tui {
namespace {

// Where there are no colours, and where there is only ASCII.
TEST(LevelMarks, DifferInMoreThanColour) {
  std::set<char32_t> glyphs;
  std::set<char32_t> ascii;
  for (const LevelMark& mark : level_marks) {
    glyphs.insert(mark.glyph);
    ascii.insert(ascii_glyph(mark.glyph));
  }
  EXPECT_EQ(glyphs.size(), level_marks.size());
  EXPECT_EQ(ascii.size(), level_marks.size());
  EXPECT_FALSE(ascii.contains(U'?'));
}

}  // namespace
}  // namespace tapfit::tui
