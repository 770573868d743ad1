#include "tui/screen/dots.hpp"

#include "tui/screen/palette.hpp"
#include "tui/screen/pixel_pen.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::tui {
namespace {

struct Segment {
  double x0, y0, x1, y1;
};

/// Liang and Barsky's clipping to 0..w x 0..h and a margin around it; false
/// when nothing is left.
bool clip(Segment& s, double margin, double w, double h) {
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const std::array<double, 4> p{-dx, dx, -dy, dy};
  const std::array<double, 4> q{
      s.x0 + margin, w + margin - s.x0, s.y0 + margin, h + margin - s.y0};
  double from = 0.0;
  double to = 1.0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (p[i] == 0.0) {
      if (q[i] < 0.0) return false;
      continue;
    }
    const double t = q[i] / p[i];
    if (p[i] < 0.0) {
      from = std::max(from, t);
    } else {
      to = std::min(to, t);
    }
  }
  if (from > to) return false;
  s = {s.x0 + from * dx, s.y0 + from * dy, s.x0 + to * dx, s.y0 + to * dy};
  return true;
}

bool shows(Pattern pattern, int position) {
  if (pattern == Pattern::Dashed) return position % 6 < 4;
  if (pattern == Pattern::Dotted) return position % 3 == 0;
  return true;
}

// Halves go up, also where rounding has left them a hair short: lines look the
// same whatever the processor's instructions.
int nearest_dot(double at) {
  return static_cast<int>(std::floor(at + 0.5 + 1e-6));
}

/// A tenth of a cell's height wide, broken in grains.
PixelPen pixel_pen(const Pen& pen, int cell_height, double grain) {
  PixelPen with;
  with.width = std::max(cell_height / 10.0, 1.0);
  with.ink = ink_number(pen.colour, pen.dim);
  if (pen.pattern == Pattern::Dashed) {
    with.drawn = 4.0 * grain;
    with.period = 6.0 * grain;
  } else if (pen.pattern == Pattern::Dotted) {
    with.drawn = grain;
    with.period = 3.0 * grain;
  }
  return with;
}

}  // namespace

Dots::Dots(int width, int height, const Screen& screen)
    : width_(std::max(width, 0)),
      height_(std::max(height, 0)),
      ascii_(screen.ascii()) {
  const CellPixels cell = ascii_ ? CellPixels{} : screen.pixels();
  across_ = !cell.none() ? cell.width : ascii_ ? 1 : 2;
  down_ = !cell.none() ? cell.height : ascii_ ? 1 : 4;
  if (cell.none()) {
    spots_.resize(static_cast<std::size_t>(width_) *
                  static_cast<std::size_t>(height_));
  } else {
    picture_ = blank_picture({0, 0, width_, height_}, cell);
  }
}

double Dots::flatness() const { return ascii_ ? 0.5 : 1.0; }

double Dots::grain() const {
  return in_pixels() ? std::max(down_ / 8.0, 1.0) : 1.0;
}

void Dots::set(int x, int y, const Pen& pen) {
  if (x < 0 || y < 0 || x >= width() || y >= height()) return;
  static constexpr std::array<std::array<unsigned, 2>, 4> bits{
      {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};
  const int column = x / across_;
  const int row = y / down_;
  Spot& spot =
      spots_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
             static_cast<std::size_t>(column)];
  spot.bits |= ascii_ ? 1U
                      : bits[static_cast<std::size_t>(y % 4)]
                            [static_cast<std::size_t>(x % 2)];
  spot.pen = pen;
}

void Dots::line(double x0, double y0, double x1, double y1, const Pen& pen) {
  if (!std::isfinite(x0 + y0 + x1 + y1)) return;
  Segment s{x0, y0, x1, y1};
  if (in_pixels()) {
    const PixelPen with = pixel_pen(pen, down_, grain());
    if (!clip(s, with.width, width(), height())) return;
    return stroke(picture_, s.x0, s.y0, s.x1, s.y1, with);
  }
  if (!clip(s, 0.0, width() - 1.0, height() - 1.0)) return;
  const double span = std::max(std::abs(s.x1 - s.x0), std::abs(s.y1 - s.y0));
  const int steps = static_cast<int>(std::ceil(span));
  const bool steep = std::abs(s.y1 - s.y0) > std::abs(s.x1 - s.x0);
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
    const int x = nearest_dot(s.x0 + t * (s.x1 - s.x0));
    const int y = nearest_dot(s.y0 + t * (s.y1 - s.y0));
    if (shows(pen.pattern, steep ? y : x)) set(x, y, pen);
  }
}

void Dots::spot(double x, double y, const Pen& pen) {
  if (!in_pixels()) return line(x, y, x, y, pen);
  if (!std::isfinite(x + y)) return;
  PixelPen with = pixel_pen(pen, down_, 0.0);
  with.width *= 2.0;
  Segment s{x, y, x, y};
  if (clip(s, with.width, width(), height())) {
    stroke(picture_, x, y, x, y, with);
  }
}

void Dots::foot(double x, double y, const Pen& pen) {
  if (in_pixels()) {
    const double reach = 2.0 * grain();
    return line(x - reach, y, x + reach, y, pen);
  }
  const int column = static_cast<int>(std::lround(x));
  const int row = static_cast<int>(std::lround(y));
  set(column - 1, row, pen);
  set(column + 1, row, pen);
}

void Dots::shade(double from, double to, Colour colour) {
  const int fine = std::max(static_cast<int>(grain() / 2.0), 1);
  dither(picture_, from, to, fine, ink_number(colour, true));
}

void Dots::draw(Screen& screen, int x, int y) const {
  if (in_pixels()) {
    PixelPicture picture = picture_;
    picture.rect.x = x;
    picture.rect.y = y;
    return screen.add(picture);
  }
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const Spot& spot = spots_[static_cast<std::size_t>(row) *
                                    static_cast<std::size_t>(width_) +
                                static_cast<std::size_t>(column)];
      if (spot.bits == 0) continue;
      const char32_t glyph = ascii_
                                 ? static_cast<char32_t>(spot.pen.mark)
                                 : static_cast<char32_t>(0x2800U + spot.bits);
      Style style;
      style.colour = spot.pen.colour;
      style.dim = spot.pen.dim;
      screen.put(x + column, y + row, glyph, style);
    }
  }
}

}  // namespace tapfit::tui
