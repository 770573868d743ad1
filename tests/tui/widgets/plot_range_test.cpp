#include "tui/widgets/plot_range.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(PlotRange, ZoomsAboutTheCursorAndBack) {
  PlotRange range;
  range.cursor = 80.0;
  range.cursor_set = true;
  EXPECT_TRUE(range_key(range, Key(U'+'), 0.0, 100.0));
  EXPECT_DOUBLE_EQ(range.lo, 50.0);  // 55 .. 105 pushed back inside
  EXPECT_DOUBLE_EQ(range.hi, 100.0);
  EXPECT_TRUE(range_key(range, Key(U'-'), 0.0, 100.0));
  EXPECT_DOUBLE_EQ(range.lo, 0.0);
  EXPECT_DOUBLE_EQ(range.hi, 100.0);
}

TEST(PlotRange, NeverLeavesWhatThereIs) {
  PlotRange range;
  const std::string all = "++[[[[[[[]]]]]]]]]]]--+HHHHHHHHHLLLLLLLLLLLLLLLLLLL";
  for (const char c : all) {
    range_key(range, Key(static_cast<char32_t>(c)), 1.0, 3.0);
    const PlotRange r = resolved(range, 1.0, 3.0);
    // Room for rounding in lo + width only.
    EXPECT_GE(r.lo, 1.0 - 1e-12);
    EXPECT_LE(r.hi, 3.0 + 1e-12);
    EXPECT_LT(r.lo, r.hi);
  }
}

TEST(PlotRange, CursorPullsTheStretchAlong) {
  PlotRange range{0.0, 10.0, 9.95, true};
  range_key(range, Key(keys::right), 0.0, 100.0);
  EXPECT_GT(range.cursor, 10.0);
  EXPECT_LE(range.cursor, range.hi);
}

TEST(PlotRange, TakesAnEmptyAxis) {
  PlotRange range;
  EXPECT_FALSE(range_key(range, Key(U'+'), 0.0, 0.0));
}

}  // namespace
}  // namespace tapfit::tui
