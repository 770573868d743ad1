// Pictures on screens: they go where screens go, and what is put over them
// stays readable.
#include "tui/screen/pixel_picture.hpp"

#include "tui/screen/screen.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

constexpr CellPixels small_cell{4, 6};

PixelPicture filled(const Rect& rect) {
  PixelPicture picture = blank_picture(rect, small_cell);
  for (Pixel& pixel : picture.pixels) pixel = {1, 255};
  return picture;
}

int covered_pixels(const Screen& screen) {
  int count = 0;
  for (const PixelPicture& picture : screen.pictures()) {
    for (const Pixel& pixel : picture.pixels) count += pixel.cover > 0 ? 1 : 0;
  }
  return count;
}

TEST(PixelPicture, IsCutAtTheScreensEdges) {
  Screen screen(10, 5);
  screen.add(filled({8, 3, 4, 4}));
  ASSERT_EQ(screen.pictures().size(), 1U);
  EXPECT_EQ(screen.pictures()[0].rect, (Rect{8, 3, 2, 2}));
  EXPECT_EQ(covered_pixels(screen), 2 * 2 * 4 * 6);
  screen.add(filled({20, 3, 4, 4}));
  EXPECT_EQ(screen.pictures().size(), 1U);
}

TEST(PixelPicture, KeepsItsPixelsWhereItIsCut) {
  PixelPicture picture = blank_picture({-1, 0, 3, 2}, small_cell);
  picture.at(5, 7) = {3, 200};
  const PixelPicture part = part_within(picture, {0, 1, 5, 5});
  EXPECT_EQ(part.rect, (Rect{0, 1, 2, 1}));
  EXPECT_EQ(part.at(1, 1), (Pixel{3, 200}));
}

TEST(PixelPicture, IsGoneWhereBlanksArePutOverItAndLiesUnderGlyphs) {
  Screen screen(10, 5);
  screen.add(filled({0, 0, 10, 5}));
  screen.text(3, 3, "x y");
  EXPECT_EQ(covered_pixels(screen), 50 * 24);
  screen.fill({2, 1, 4, 2}, U' ');
  EXPECT_EQ(covered_pixels(screen), 42 * 24);
}

TEST(PixelPicture, GoesWithTheScreenItIsOn) {
  Screen pane(4, 3);
  pane.add(filled({1, 1, 2, 1}));
  Screen screen(10, 5);
  screen.add(filled({0, 0, 10, 5}));
  screen.place(5, 2, pane);
  ASSERT_EQ(screen.pictures().size(), 2U);
  EXPECT_EQ(screen.pictures()[1].rect, (Rect{6, 3, 2, 1}));
  EXPECT_EQ(covered_pixels(screen), (50 - 12 + 2) * 24);
}

}  // namespace
}  // namespace tapfit::tui
