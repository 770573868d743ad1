// Rectangles of cells, cut into panes.
#pragma once

#include <algorithm>
#include <utility>

namespace tapfit::tui {

/// Width and height may be zero, never negative.
struct Rect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  [[nodiscard]] bool holds(int px, int py) const {
    return px >= x && px < x + width && py >= y && py < y + height;
  }

  bool operator==(const Rect&) const = default;
};

/// The first `rows` rows, and what is left below them.
[[nodiscard]] inline std::pair<Rect, Rect> split_top(const Rect& r, int rows) {
  const int top = std::clamp(rows, 0, std::max(r.height, 0));
  return {{r.x, r.y, r.width, top},
          {r.x, r.y + top, r.width, std::max(r.height, 0) - top}};
}

/// The first `columns` columns, and what is left to the right of them.
[[nodiscard]] inline std::pair<Rect, Rect> split_left(const Rect& r,
                                                      int columns) {
  const int left = std::clamp(columns, 0, std::max(r.width, 0));
  return {{r.x, r.y, left, r.height},
          {r.x + left, r.y, std::max(r.width, 0) - left, r.height}};
}

/// What is left inside a box's border.
[[nodiscard]] inline Rect inside(const Rect& r) {
  return {
      r.x + 1, r.y + 1, std::max(r.width - 2, 0), std::max(r.height - 2, 0)};
}

}  // namespace tapfit::tui
