// A grid of fine dots over cells: pixels where the screen has them, else 2 x 4
// braille dots per cell, or one ASCII mark per cell where braille is not to be
// had. Lines and areas are drawn in dots, then put on a screen.
//
// Braille dot bits of U+2800: left column 1 2 4 40h, right column 8 10h 20h
// 80h, from top to bottom (Unicode Standard, chapter 21.1).
#pragma once

#include "tui/screen/screen.hpp"

#include <vector>

namespace tapfit::tui {

/// How a line is broken, so that curves stay apart without colour.
enum class Pattern { Solid, Dashed, Dotted };

struct Pen {
  Colour colour = Colour::Default;
  Pattern pattern = Pattern::Solid;
  char mark = '*';  ///< in ASCII
  bool dim = false;
};

class Dots {
 public:
  /// @param width, height in cells
  /// @param screen that it is for
  Dots(int width, int height, const Screen& screen);

  [[nodiscard]] int width() const { return width_ * across_; }  ///< [dots]
  [[nodiscard]] int height() const { return height_ * down_; }  ///< [dots]
  [[nodiscard]] int across() const { return across_; }  ///< dots of a cell
  [[nodiscard]] int down() const { return down_; }      ///< its rows of dots
  [[nodiscard]] bool in_pixels() const { return !picture_.cell.none(); }
  /// Dots down that are as long as one across. A cell is taken as twice as high
  /// as wide, unless its pixels are known.
  [[nodiscard]] double flatness() const;
  /// What is this long or this far apart can be told apart [dots].
  [[nodiscard]] double grain() const;

  /// A line between points in dots, (0, 0) being top left; clipped; nothing
  /// for what is not finite.
  void line(double x0, double y0, double x1, double y1, const Pen& pen);
  /// A single one of several.
  void spot(double x, double y, const Pen& pen);
  /// What a stem stands on, so that a short one is seen as well.
  void foot(double x, double y, const Pen& pen);
  /// All of the height, faintly, between two columns.
  /// @pre in_pixels()
  void shade(double from, double to, Colour colour);

  /// Puts cells that hold a dot at (x, y), others are left as they are.
  void draw(Screen& screen, int x, int y) const;

 private:
  struct Spot {
    unsigned bits = 0;
    Pen pen;
  };

  void set(int x, int y, const Pen& pen);

  int width_;
  int height_;
  bool ascii_;
  int across_;
  int down_;
  std::vector<Spot> spots_;  ///< per cell
  PixelPicture picture_;     ///< in their place, where there are pixels
};

}  // namespace tapfit::tui
