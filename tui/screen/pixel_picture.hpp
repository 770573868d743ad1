// What is drawn in pixels over a rectangle of cells, where the terminal has
// them. How it gets there is kitty_graphics.hpp and sixel_graphics.hpp.
#pragma once

#include "tui/screen/layout.hpp"

#include <cstdint>
#include <vector>

namespace tapfit::tui {

/// A cell's size [pixels]; 0 where cells hold nothing but glyphs.
struct CellPixels {
  int width = 0;
  int height = 0;

  [[nodiscard]] bool none() const { return width <= 0 || height <= 0; }

  bool operator==(const CellPixels&) const = default;
};

struct Pixel {
  std::uint8_t ink = 0;    ///< as of ink_number() (palette.hpp)
  std::uint8_t cover = 0;  ///< how much of the ink there is: 0 none, 255 all

  bool operator==(const Pixel&) const = default;
};

struct PixelPicture {
  Rect rect;  ///< [cells]
  CellPixels cell;
  std::vector<Pixel> pixels;  ///< height() rows of width(), from the top

  [[nodiscard]] int width() const { return rect.width * cell.width; }
  [[nodiscard]] int height() const { return rect.height * cell.height; }
  /// @pre 0 <= x < width(), 0 <= y < height()
  [[nodiscard]] const Pixel& at(int x, int y) const {
    return pixels[index_of(x, y)];
  }
  [[nodiscard]] Pixel& at(int x, int y) { return pixels[index_of(x, y)]; }
  [[nodiscard]] bool blank() const;

  bool operator==(const PixelPicture&) const = default;

 private:
  [[nodiscard]] std::size_t index_of(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x);
  }
};

/// Without a pixel drawn.
[[nodiscard]] PixelPicture blank_picture(const Rect& rect, CellPixels cell);

/// What of it lies within an area of cells; its rectangle may be empty.
[[nodiscard]] PixelPicture part_within(const PixelPicture& picture,
                                       const Rect& area);

/// Takes away what is drawn in the screen's cell (x, y), if it lies there.
void clear_cell(PixelPicture& picture, int x, int y);

}  // namespace tapfit::tui
