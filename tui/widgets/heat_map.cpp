#include "tui/widgets/heat_map.hpp"

#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

std::string entry(double value) {
  if (!std::isfinite(value)) return "–";
  const double hundredths = std::round(100.0 * value);
  if (hundredths > 999.0) return ">9x";
  return fmt::format("{:.0f}", std::max(hundredths, 0.0));
}

/// ".998", "1.00": how much is lacking shows in the third decimal.
std::string share_entry(double value) {
  if (!std::isfinite(value)) return "–";
  if (value >= 0.9995) return "1.00";
  return fmt::format("{:.3f}", std::max(value, 0.0)).substr(1);
}

int name_width(const HeatMap& map) {
  int width = 0;
  for (const std::string& name : map.row_names) {
    width = std::max(width, text_width(name));
  }
  return width;
}

/// Cells that the names on the left may take.
int name_room(const Rect& rect, const HeatMap& map) {
  return std::min(name_width(map), std::max(rect.width / 3, 8));
}

const std::string& at_or_empty(const std::vector<std::string>& names,
                               Eigen::Index i) {
  static const std::string empty;
  const auto at = static_cast<std::size_t>(i);
  return at < names.size() ? names[at] : empty;
}

}  // namespace

int heat_of(double value, double scale) {
  if (!std::isfinite(value) || !(scale > 0.0)) return 0;
  const double level = std::floor(value / scale * heat_levels + 0.5);
  return static_cast<int>(std::clamp(level, 0.0, double{heat_levels}));
}

int fitting_columns(const Rect& rect, const HeatMap& map) {
  const int room = rect.width - name_room(rect, map) - 2;
  return std::max(room / map.entry_width, 0);
}

void scroll_to_mark(HeatMap& map, const Rect& rect) {
  const int columns = std::max(fitting_columns(rect, map), 1);
  map.left = std::max({map.first, map.left, map.column - columns + 1});
  map.top = std::max({0, map.top, map.selected - rect.height + 2});
}

void draw_heat_map(Screen& screen, const Rect& rect, const HeatMap& map) {
  if (rect.empty()) return;
  keep_drawing(screen, map);
  const int names = name_room(rect, map);
  const int entry_width = map.entry_width;
  const int columns = fitting_columns(rect, map);
  const auto shown_columns =
      std::min<Eigen::Index>(map.values.cols() - map.left, columns);
  for (Eigen::Index c = 0; c < shown_columns; ++c) {
    const int x = rect.x + names + 2 + static_cast<int>(c) * entry_width;
    screen.text_right(x + entry_width - 1,
                      rect.y,
                      at_or_empty(map.column_names, map.left + c),
                      {.colour = Colour::Grey},
                      entry_width - 1);
  }
  if (map.left > map.first) screen.put(rect.x, rect.y, U'←');
  if (map.left + shown_columns < map.values.cols()) {
    screen.put(rect.x + rect.width - 1, rect.y, U'→');
  }
  const auto shown_rows =
      std::min<Eigen::Index>(map.values.rows() - map.top, rect.height - 1);
  for (Eigen::Index r = 0; r < shown_rows; ++r) {
    const int y = rect.y + 1 + static_cast<int>(r);
    const Eigen::Index row = map.top + r;
    const bool marked = row == map.selected;
    if (marked) screen.put(rect.x, y, U'▸', {.bold = true});
    screen.text_right(rect.x + names + 1,
                      y,
                      at_or_empty(map.row_names, row),
                      {.bold = marked},
                      names);
    for (Eigen::Index c = 0; c < shown_columns; ++c) {
      const double value = map.values(row, map.left + c);
      const int x = rect.x + names + 2 + static_cast<int>(c) * entry_width;
      Style style;
      style.heat = static_cast<std::uint8_t>(
          heat_of((map.shortfall ? 1.0 - value : value) - map.cold,
                  map.scale - map.cold));
      style.bold = style.heat >= 5;
      style.reverse = marked && map.left + c == map.column;
      screen.fill({x, y, entry_width, 1}, U' ', style);
      screen.text_right(x + entry_width - 1,
                        y,
                        map.shortfall ? share_entry(value) : entry(value),
                        style,
                        entry_width - 1);
      screen.zone({.rect = {x, y, entry_width, 1},
                   .kind = Zone::Kind::Entry,
                   .index = static_cast<std::size_t>(row),
                   .column = static_cast<std::size_t>(map.left + c)});
    }
  }
  const int right = rect.x + rect.width - 1;
  if (map.top > 0) screen.put(right, rect.y + 1, U'↑');
  if (map.top + shown_rows < map.values.rows()) {
    screen.put(right, rect.y + static_cast<int>(shown_rows), U'↓');
  }
}

}  // namespace tapfit::tui
