// Lines in pixels against what lies within half a pen's width of a segment.
#include "tui/screen/pixel_pen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

PixelPicture stroked(
    double x0, double y0, double x1, double y1, const PixelPen& pen) {
  PixelPicture picture = blank_picture({0, 0, 4, 2}, CellPixels{10, 20});
  stroke(picture, x0, y0, x1, y1, pen);
  return picture;
}

double distance(double x, double y, double x1, double y1) {
  // To the segment from (3, 5) to there.
  const double dx = x1 - 3.0;
  const double dy = y1 - 5.0;
  const double t = std::clamp(
      ((x - 3.0) * dx + (y - 5.0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - 3.0 - t * dx, y - 5.0 - t * dy);
}

TEST(PixelPen, DrawsWhatLiesWithinHalfItsWidth) {
  const PixelPen pen{.width = 3.0, .ink = 7};
  const double ends[][2] = {
      {30.0, 5.0}, {3.0, 33.0}, {36.5, 20.25}, {8.0, 38.0}};
  for (const auto& end : ends) {
    const PixelPicture picture = stroked(3.0, 5.0, end[0], end[1], pen);
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const double share =
            std::clamp(2.0 - distance(x, y, end[0], end[1]), 0.0, 1.0);
        EXPECT_NEAR(picture.at(x, y).cover, 255.0 * share, 1.0)
            << x << ' ' << y << " to " << end[0] << ' ' << end[1];
      }
    }
  }
}

TEST(PixelPen, BreaksALineTheSameWhereverItsSegmentsEnd) {
  const PixelPen pen{.width = 1.0, .ink = 1, .drawn = 4.0, .period = 6.0};
  const PixelPicture whole = stroked(0.0, 9.0, 39.0, 9.0, pen);
  PixelPicture parts = stroked(0.0, 9.0, 7.0, 9.0, pen);
  stroke(parts, 7.0, 9.0, 39.0, 9.0, pen);
  EXPECT_EQ(whole, parts);
  EXPECT_EQ(whole.at(3, 9).cover, 255);
  EXPECT_EQ(whole.at(4, 9).cover, 0);
}

TEST(PixelPen, LaysALineOverThoseBefore) {
  PixelPicture picture = stroked(0.0, 10.0, 39.0, 10.0, {2.0, 1});
  stroke(picture, 20.0, 0.0, 20.0, 39.0, {2.0, 2});
  EXPECT_EQ(picture.at(20, 10).ink, 2);
  EXPECT_EQ(picture.at(25, 10).ink, 1);
}

TEST(PixelPen, DrawsADotWhereBothEndsAreOne) {
  const PixelPicture picture = stroked(10.0, 10.0, 10.0, 10.0, {4.0, 1});
  EXPECT_EQ(picture.at(10, 10).cover, 255);
  EXPECT_EQ(picture.at(11, 11).cover, 255);
  EXPECT_EQ(picture.at(13, 13).cover, 0);
}

}  // namespace
}  // namespace tapfit::tui
