// Lists: columns with a heading, one selected row, scrolling and a filter.
#pragma once

#include "tui/screen/key.hpp"
#include "tui/screen/screen.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

struct Column {
  std::string title;
  bool right = false;  ///< numbers stand to the right
  bool bars = false;   ///< drawn as in any other row where it is selected
  /// What rows are sorted by it under: its title where nothing is said; not at
  /// all by one without a name.
  std::optional<std::string> sorts = {};

  [[nodiscard]] const std::string& name() const {
    return sorts ? *sorts : title;
  }
};

struct Row {
  std::vector<std::string> cells;
  Style style;
  /// As cells, what they are sorted by; empty: by the cells.
  std::vector<std::string> keys = {};
};

struct Table {
  std::vector<Column> columns;
  std::vector<Row> rows;
  bool sortable = false;  ///< by clicks on its headings, too
};

struct ListState {
  std::size_t selected = 0;  ///< index into Table::rows
  std::string filter;        ///< rows without this text are hidden
  /// Name of the column by which rows stand; empty, or of no column: as they
  /// come.
  std::string sorted_by = {};
  bool rising = false;  ///< numbers from the smallest up
  /// No row is selected until one is gone to: what was is not listed now.
  bool nowhere = false;
};

/// Indices of the rows that hold the filter's text (any case), as they stand.
[[nodiscard]] std::vector<std::size_t> visible_rows(const Table& table,
                                                    const ListState& state);

/// Whether the filter leaves none of the rows: then there is nothing to act on.
[[nodiscard]] bool none_shown(const Table& table, const ListState& state);
/// Whether a key moves from row to row or acts on the selected one.
[[nodiscard]] bool is_row_key(Key key);
/// What is told then of keys that act on a row.
inline constexpr const char* nothing_matches =
    "the filter matches nothing; Esc clears it";

/// The selection, moved to a row that exists and is visible; 0 if none is.
[[nodiscard]] std::size_t settled(const Table& table, const ListState& state);

/// Up, Down, j, k, PageUp, PageDown, Home, End, g, G and the wheel.
///
/// @return true when the key was one of these
bool list_key(ListState& state, const Table& table, Key key, int page = 10);

/// s sorts by the first column, then by the next, then by none: texts by the
/// alphabet, numbers from the largest down, then from the smallest up.
///
/// @param told says by what, also where the column has no room on the screen
/// @return true when it was that key
bool sort_key(ListState& state, const Table& table, Key key, std::string& told);

/// A click on a heading sorts by its column: as sort_key() does, from the
/// largest number down, then up, then not at all.
void sort_by_heading(ListState& state, const Zone& heading);

/// Heading, then as many rows as fit, the selected one among them. Columns
/// that do not fit are left out from the right, but the first of them is cut
/// short where it holds text. The last cell of each row stays free.
///
/// @param active whether a row is selected; else the list is only read
void draw_table(Screen& screen,
                const Rect& rect,
                const Table& table,
                const ListState& state,
                bool active);

}  // namespace tapfit::tui
