#include "tui/widgets/text_box.hpp"

#include "tui/screen/layout.hpp"

#include <algorithm>

namespace tapfit::tui {

int text_box_rows(int screen_height) { return std::max(screen_height - 2, 0); }

void draw_text_box(Screen& screen,
                   const std::string& title,
                   const std::vector<std::string>& lines,
                   Style style,
                   int first) {
  const int count = static_cast<int>(lines.size());
  const int width = std::min(screen.width() - 4, 76);
  const int height = std::min(screen.height(), count + 2);
  const Rect rect{(screen.width() - width) / 2,
                  (screen.height() - height) / 2,
                  width,
                  height};
  screen.fill(rect, U' ');
  screen.box(rect, title, style);
  const Rect room = inside(rect);
  first = std::clamp(first, 0, std::max(count - room.height, 0));
  for (int i = 0; i < std::min(room.height, count); ++i) {
    screen.text(room.x + 1,
                room.y + i,
                lines[static_cast<std::size_t>(first + i)],
                {},
                room.width - 2);
  }
  const int right = rect.x + rect.width - 3;
  if (first > 0) screen.text_right(right, rect.y, " ↑ more ", style);
  if (first + room.height < count) {
    screen.text_right(right, rect.y + rect.height - 1, " ↓ more ", style);
  }
}

}  // namespace tapfit::tui
