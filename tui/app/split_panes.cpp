#include "tui/app/split_panes.hpp"

namespace tapfit::tui {

std::optional<Panes> split_panes(int width, int height) {
  constexpr int least_rows = least_height - frame_rows;
  const Rect all{0, 0, width, height};
  Panes panes;
  if (width > 2 * least_width && height >= least_rows) {
    const auto [first, rest] = split_left(all, (width - 1) / 2);
    const auto [line, second] = split_left(rest, 1);
    return Panes{first, second, line, true};
  }
  if (height > 2 * least_rows && width >= least_width) {
    const auto [first, rest] = split_top(all, (height - 1) / 2);
    const auto [line, second] = split_top(rest, 1);
    return Panes{first, second, line, false};
  }
  return std::nullopt;
}

}  // namespace tapfit::tui
