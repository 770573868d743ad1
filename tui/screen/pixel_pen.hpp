// Lines and shades in pixels. A line is all that lies within half the pen's
// width of a segment; at its rim a pixel is covered as far as it lies inside,
// by the distance of its middle from the rim.
#pragma once

#include "tui/screen/pixel_picture.hpp"

#include <cstdint>

namespace tapfit::tui {

struct PixelPen {
  double width = 1.0;  ///< [pixels]
  std::uint8_t ink = 0;
  /// Pixels of the longer way that are drawn out of each period, from pixel 0
  /// on: lines of many segments are broken evenly. 0: all are.
  double drawn = 0.0;
  double period = 0.0;
};

/// Between two points [pixels], (0, 0) being the middle of the first; where
/// they are one, a dot. What lies outside is dropped.
/// @pre the points are not farther outside than a picture's size
void stroke(PixelPicture& picture,
            double x0,
            double y0,
            double x1,
            double y1,
            const PixelPen& pen);

/// Every fourth grain of a grid, between two columns.
/// @param grain [pixels]
void dither(
    PixelPicture& picture, double from, double to, int grain, std::uint8_t ink);

}  // namespace tapfit::tui
