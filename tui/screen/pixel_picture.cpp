#include "tui/screen/pixel_picture.hpp"

#include <algorithm>

namespace tapfit::tui {

bool PixelPicture::blank() const {
  return std::ranges::all_of(
      pixels, [](const Pixel& pixel) { return pixel.cover == 0; });
}

PixelPicture blank_picture(const Rect& rect, CellPixels cell) {
  PixelPicture picture{rect, cell, {}};
  picture.pixels.resize(static_cast<std::size_t>(picture.width()) *
                        static_cast<std::size_t>(picture.height()));
  return picture;
}

PixelPicture part_within(const PixelPicture& picture, const Rect& area) {
  const Rect& all = picture.rect;
  Rect rect;
  rect.x = std::max(all.x, area.x);
  rect.y = std::max(all.y, area.y);
  rect.width =
      std::max(std::min(all.x + all.width, area.x + area.width) - rect.x, 0);
  rect.height =
      std::max(std::min(all.y + all.height, area.y + area.height) - rect.y, 0);
  if (rect == all) return picture;
  PixelPicture part = blank_picture(rect, picture.cell);
  const int left = (rect.x - all.x) * picture.cell.width;
  const int top = (rect.y - all.y) * picture.cell.height;
  for (int y = 0; y < part.height(); ++y) {
    for (int x = 0; x < part.width(); ++x) {
      part.at(x, y) = picture.at(left + x, top + y);
    }
  }
  return part;
}

void clear_cell(PixelPicture& picture, int x, int y) {
  if (!picture.rect.holds(x, y)) return;
  const auto [width, height] = picture.cell;
  const int left = (x - picture.rect.x) * width;
  const int top = (y - picture.rect.y) * height;
  for (int row = top; row < top + height; ++row) {
    for (int column = left; column < left + width; ++column) {
      picture.at(column, row) = {};
    }
  }
}

}  // namespace tapfit::tui
