// A grid of fine dots over cells: 2 x 4 braille dots per cell, or one ASCII
// mark per cell where braille is not to be had. Lines and areas are drawn in
// dots, then put on a screen.
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
  Dots(int width, int height, bool ascii);

  [[nodiscard]] int width() const { return dots_x_; }   ///< [dots]
  [[nodiscard]] int height() const { return dots_y_; }  ///< [dots]

  /// Dot (0, 0) is top left; what lies outside is dropped.
  void set(int x, int y, const Pen& pen);
  /// A line between points in dots, clipped; nothing for what is not finite.
  void line(double x0, double y0, double x1, double y1, const Pen& pen);

  /// Puts cells that hold a dot at (x, y), others are left as they are.
  void draw(Screen& screen, int x, int y) const;

 private:
  struct Spot {
    unsigned bits = 0;
    Pen pen;
  };

  int width_;
  int height_;
  bool ascii_;
  int dots_x_;
  int dots_y_;
  std::vector<Spot> spots_;
};

}  // namespace tapfit::tui
