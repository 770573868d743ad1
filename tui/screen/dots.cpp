#include "tui/screen/dots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::tui {
namespace {

struct Segment {
  double x0, y0, x1, y1;
};

/// Liang and Barsky's clipping to 0..w x 0..h; false when nothing is left.
bool clip(Segment& s, double w, double h) {
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const std::array<double, 4> p{-dx, dx, -dy, dy};
  const std::array<double, 4> q{s.x0, w - s.x0, s.y0, h - s.y0};
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

}  // namespace

Dots::Dots(int width, int height, bool ascii)
    : width_(std::max(width, 0)),
      height_(std::max(height, 0)),
      ascii_(ascii),
      dots_x_(ascii ? width_ : 2 * width_),
      dots_y_(ascii ? height_ : 4 * height_),
      spots_(static_cast<std::size_t>(width_) *
             static_cast<std::size_t>(height_)) {}

void Dots::set(int x, int y, const Pen& pen) {
  if (x < 0 || y < 0 || x >= dots_x_ || y >= dots_y_) return;
  static constexpr std::array<std::array<unsigned, 2>, 4> bits{
      {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};
  const int column = ascii_ ? x : x / 2;
  const int row = ascii_ ? y : y / 4;
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
  if (!clip(s, dots_x_ - 1.0, dots_y_ - 1.0)) return;
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

void Dots::draw(Screen& screen, int x, int y) const {
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
