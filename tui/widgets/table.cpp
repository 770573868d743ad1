#include "tui/widgets/table.hpp"

#include "tui/screen/line_text.hpp"
#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace tapfit::tui {
namespace {

std::string lower(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

/// Width of a text once it is on this screen.
int shown_width(const Screen& screen, const std::string& text) {
  return screen.ascii() ? static_cast<int>(to_ascii(text).size())
                        : text_width(text);
}

std::vector<int> column_widths(const Screen& screen, const Table& table) {
  std::vector<int> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    int width = shown_width(screen, table.columns[c].title);
    for (const Row& row : table.rows) {
      if (c < row.cells.size()) {
        width = std::max(width, shown_width(screen, row.cells[c]));
      }
    }
    widths.push_back(width);
  }
  return widths;
}

/// Cuts the widths to the room: a text may be cut short, a number not, as "2.…"
/// would read as two; its column and those after it are left out.
std::vector<int> fitted(std::vector<int> widths, const Table& table, int room) {
  int used = 0;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    const int left = room - used;
    if (widths[c] > left) {
      const bool dropped = left <= 0 || (c > 0 && table.columns[c].right);
      widths[c] = std::max(left, 0);
      widths.resize(dropped ? c : c + 1);
      break;
    }
    used += widths[c] + 2;
  }
  return widths;
}

void draw_cells(Screen& screen,
                const Rect& line,
                const std::vector<int>& widths,
                const Table& table,
                const std::vector<std::string>& cells,
                Style style) {
  int x = line.x;
  const Style row = style;
  for (std::size_t c = 0; c < cells.size() && c < widths.size(); ++c) {
    style = row;
    // A full bar in reverse would look like an empty one.
    if (table.columns[c].bars) style.reverse = false;
    if (table.columns[c].right) {
      screen.text_right(x + widths[c], line.y, cells[c], style, widths[c]);
    } else {
      screen.text(x, line.y, cells[c], style, widths[c]);
    }
    x += widths[c] + 2;
  }
}

/// A click on a title, or on the gap behind it.
void add_heading_zones(Screen& screen,
                       const Rect& line,
                       const std::vector<int>& widths,
                       const Table& table) {
  int x = line.x;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    const Column& column = table.columns[c];
    if (!column.name().empty()) {
      Zone zone{.rect = {x, line.y, widths[c] + 1, 1},
                .kind = Zone::Kind::Heading};
      zone.name = column.name();
      zone.column = column.right ? 1 : 0;
      screen.zone(zone);
    }
    x += widths[c] + 2;
  }
}

const std::string& cell(const Row& row, std::size_t column) {
  static const std::string none;
  return column < row.cells.size() ? row.cells[column] : none;
}

const std::string& sorting_cell(const Row& row, std::size_t column) {
  return column < row.keys.size() ? row.keys[column] : cell(row, column);
}

/// Of all columns where there is none.
std::size_t sorting_column(const Table& table, const ListState& state) {
  if (state.sorted_by.empty()) return table.columns.size();
  const auto found =
      std::ranges::find(table.columns, state.sorted_by, &Column::name);
  return static_cast<std::size_t>(found - table.columns.begin());
}

/// "<0.001", "+9.12 %", "−0.5" and, tagged, "*1" are numbers, "–" is none.
std::optional<double> number_of(const std::string& text) {
  const std::size_t first = text.find_first_not_of("<* ");
  if (first == std::string::npos) return std::nullopt;
  constexpr std::string_view minus = "−";
  const bool below = text.compare(first, minus.size(), minus) == 0;
  const char* begin = text.c_str() + first + (below ? minus.size() : 0);
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  if (end == begin) return std::nullopt;
  return below ? -value : value;
}

/// Digits as the number that they are: "60Z+" before "145Z+".
bool stands_before(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < a.size() && k < b.size()) {
    if (digit(a[i]) && digit(b[k])) {
      char* after_a = nullptr;
      char* after_b = nullptr;
      const double one = std::strtod(a.c_str() + i, &after_a);
      const double other = std::strtod(b.c_str() + k, &after_b);
      if (one != other) return one < other;
      i = static_cast<std::size_t>(after_a - a.c_str());
      k = static_cast<std::size_t>(after_b - b.c_str());
    } else {
      if (a[i] != b[k]) return a[i] < b[k];
      ++i;
      ++k;
    }
  }
  return a.size() - i < b.size() - k;
}

/// The text without the mark of a tag.
std::string sorted_text(const std::string& cell) {
  return lower(cell.starts_with("* ") ? cell.substr(2) : cell);
}

/// What is no number stands below those that are.
bool stands_above(const std::string& a,
                  const std::string& b,
                  bool numbers,
                  bool rising) {
  if (!numbers) return stands_before(sorted_text(a), sorted_text(b));
  const auto one = number_of(a);
  const auto other = number_of(b);
  if (!one || !other) return one.has_value() && !other.has_value();
  return rising ? *one < *other : *one > *other;
}

std::size_t place_of(const std::vector<std::size_t>& rows, std::size_t row) {
  const auto found = std::find(rows.begin(), rows.end(), row);
  return found == rows.end() ? 0
                             : static_cast<std::size_t>(found - rows.begin());
}

}  // namespace

std::vector<std::size_t> visible_rows(const Table& table,
                                      const ListState& state) {
  std::vector<std::size_t> rows;
  const std::string wanted = lower(state.filter);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const std::vector<std::string>& cells = table.rows[r].cells;
    const bool shown =
        wanted.empty() ||
        std::any_of(cells.begin(), cells.end(), [&](const std::string& cell) {
          return lower(cell).find(wanted) != std::string::npos;
        });
    if (shown) rows.push_back(r);
  }
  const std::size_t column = sorting_column(table, state);
  if (column == table.columns.size()) return rows;
  std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
    return stands_above(sorting_cell(table.rows[a], column),
                        sorting_cell(table.rows[b], column),
                        table.columns[column].right,
                        state.rising);
  });
  return rows;
}

bool none_shown(const Table& table, const ListState& state) {
  return !table.rows.empty() && visible_rows(table, state).empty();
}

std::size_t settled(const Table& table, const ListState& state) {
  const std::vector<std::size_t> rows = visible_rows(table, state);
  if (rows.empty()) return 0;
  // The one itself, else the next as they come, else the last.
  std::size_t next = *std::ranges::max_element(rows);
  for (const std::size_t row : rows) {
    if (row >= state.selected) next = std::min(next, row);
  }
  return next;
}

bool is_row_key(Key key) {
  const std::array<Key, 15> all{U'j',
                                U'k',
                                U'g',
                                U'G',
                                U't',
                                U' ',
                                U'a',
                                U'i',
                                keys::up,
                                keys::down,
                                keys::home,
                                keys::end,
                                keys::page_up,
                                keys::page_down,
                                keys::enter};
  return std::ranges::find(all, key) != all.end();
}

bool list_key(ListState& state, const Table& table, Key key, int page) {
  const std::vector<std::size_t> rows = visible_rows(table, state);
  if (rows.empty()) return false;
  const auto last = static_cast<long>(rows.size()) - 1;
  auto at = state.nowhere
                ? -1L
                : static_cast<long>(place_of(rows, settled(table, state)));
  if (key == keys::up || key == U'k' || key == keys::wheel_up) {
    at -= 1;
  } else if (key == keys::down || key == U'j' || key == keys::wheel_down) {
    at += 1;
  } else if (key == keys::page_up) {
    at -= page;
  } else if (key == keys::page_down) {
    at += page;
  } else if (key == keys::home || key == U'g') {
    at = 0;
  } else if (key == keys::end || key == U'G') {
    at = last;
  } else {
    return false;
  }
  state.selected = rows[static_cast<std::size_t>(std::clamp(at, 0L, last))];
  state.nowhere = false;
  return true;
}

bool sort_key(ListState& state,
              const Table& table,
              Key key,
              std::string& told) {
  if (key != U's') return false;
  const std::size_t at = sorting_column(table, state);
  const std::size_t count = table.columns.size();
  if (at < count && table.columns[at].right && !state.rising) {
    state.rising = true;
  } else {
    state.rising = false;
    std::size_t next = at == count ? 0 : at + 1;
    while (next < count && table.columns[next].name().empty()) ++next;
    state.sorted_by = next < count ? table.columns[next].name() : "";
  }
  told = state.sorted_by.empty() ? "not sorted"
                                 : "sorted by " + state.sorted_by +
                                       (state.rising ? ", rising" : "");
  return true;
}

void sort_by_heading(ListState& state, const Zone& heading) {
  const bool numbers = heading.column != 0;
  if (state.sorted_by != heading.name) {
    state.sorted_by = heading.name;
    state.rising = false;
  } else if (numbers && !state.rising) {
    state.rising = true;
  } else {
    state.sorted_by.clear();
    state.rising = false;
  }
}

void draw_table(Screen& screen,
                const Rect& rect,
                const Table& table,
                const ListState& state,
                bool active) {
  if (rect.empty()) return;
  // The last cell is a gap before what stands beside, and the arrows' place.
  const std::vector<int> widths =
      fitted(column_widths(screen, table), table, rect.width - 2);
  std::vector<std::string> titles;
  for (const Column& column : table.columns) titles.push_back(column.title);
  const Rect indented{rect.x + 1, rect.y, rect.width - 2, 1};
  draw_cells(screen, indented, widths, table, titles, {.colour = Colour::Grey});
  if (active && table.sortable)
    add_heading_zones(screen, indented, widths, table);
  const std::size_t sorted = sorting_column(table, state);
  if (sorted < widths.size()) {
    // In the gap behind the title.
    const int behind =
        table.columns[sorted].right
            ? widths[sorted]
            : std::min(shown_width(screen, titles[sorted]), widths[sorted]);
    const int x =
        std::accumulate(widths.begin(),
                        widths.begin() + static_cast<std::ptrdiff_t>(sorted),
                        indented.x + behind + 2 * static_cast<int>(sorted));
    screen.put(x, rect.y, state.rising ? U'▴' : U'▾', {.colour = Colour::Sky});
  }
  const std::vector<std::size_t> rows = visible_rows(table, state);
  const int room = rect.height - 1;
  if (room <= 0) return;
  if (none_shown(table, state)) {
    screen.text(rect.x + 1,
                rect.y + 1,
                fitting({"nothing matches; Esc clears the filter",
                         "nothing matches (Esc)"},
                        rect.width - 2),
                {.colour = Colour::Grey},
                rect.width - 2);
  }
  const std::size_t selected = settled(table, state);
  const auto at = static_cast<int>(place_of(rows, selected));
  const int count = static_cast<int>(rows.size());
  const int top = std::clamp(at - room / 2, 0, std::max(count - room, 0));
  for (int i = 0; i < std::min(room, count - top); ++i) {
    const int shown = top + i;
    const std::size_t r = rows[static_cast<std::size_t>(shown)];
    const Rect line{rect.x + 1, rect.y + 1 + i, rect.width - 2, 1};
    Style style = table.rows[r].style;
    if (active && r == selected && !state.nowhere) {
      style.reverse = true;
      style.bold = true;
      screen.fill({rect.x, line.y, rect.width, 1}, U' ', style);
      screen.put(rect.x, line.y, U'▸', style);
    }
    draw_cells(screen, line, widths, table, table.rows[r].cells, style);
    if (active)
      screen.zone({{rect.x, line.y, rect.width, 1}, Zone::Kind::Row, r});
  }
  if (top > 0) screen.put(rect.x + rect.width - 1, rect.y, U'↑');
  if (top + room < count) {
    screen.put(rect.x + rect.width - 1, rect.y + rect.height - 1, U'↓');
  }
}

}  // namespace tapfit::tui
