#include "tui/options/csv_table.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/screen/csv_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;

/// Cells by the names of their columns.
using NamedCells = std::vector<std::pair<std::string, std::string>>;

std::string scalar_cell(const ordered_json& value) {
  if (value.is_null()) return {};
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string list_cell(const ordered_json& list) {
  const bool plain = std::ranges::none_of(
      list, [](const ordered_json& one) { return one.is_structured(); });
  if (!plain) return list.dump();
  std::vector<std::string> cells;
  for (const ordered_json& one : list) cells.push_back(scalar_cell(one));
  const bool words = !list.empty() && list.front().is_string();
  return fmt::format("{}", fmt::join(cells, words ? "; " : " "));
}

void add_cells(NamedCells& cells,
               const std::string& name,
               const ordered_json& value) {
  if (!value.is_object()) {
    cells.emplace_back(
        name, value.is_array() ? list_cell(value) : scalar_cell(value));
    return;
  }
  for (const auto& [key, inner] : value.items()) {
    add_cells(cells, name.empty() ? key : name + "." + key, inner);
  }
}

/// Of a matrix a row, of a list of words one cell.
void add_entry(NamedCells& cells, const ordered_json& entry) {
  if (entry.is_array()) {
    for (std::size_t i = 0; i < entry.size(); ++i) {
      add_cells(cells, std::to_string(i + 1), entry[i]);
    }
  } else {
    add_cells(cells, entry.is_object() ? "" : "value", entry);
  }
}

/// The rows of what the path leads to.
/// @param before cells of what it lies in
void add_rows(std::vector<NamedCells>& rows,
              const ordered_json& at,
              std::string_view path,
              const NamedCells& before) {
  if (path.empty()) {
    for (const auto& [key, entry] : at.items()) {
      NamedCells cells = before;
      if (at.is_object()) cells.emplace_back("name", key);
      add_entry(cells, entry);
      rows.push_back(std::move(cells));
    }
    return;
  }
  const std::string key(path.substr(0, path.find('.')));
  const std::string_view rest =
      path.substr(std::min(path.size(), key.size() + 1));
  for (const ordered_json& one : at) {
    NamedCells cells = before;
    for (const auto& [name, value] : one.items()) {
      if (!value.is_structured()) add_cells(cells, name, value);
    }
    if (one.contains(key)) add_rows(rows, one[key], rest, cells);
  }
}

/// Whether a path leads on from there; unknown where all that it passes is
/// empty, which may hold anything.
std::optional<bool> leads_on(const ordered_json& at, std::string_view path) {
  if (path.empty()) return at.is_structured();
  const std::string key(path.substr(0, path.find('.')));
  const std::string_view rest =
      path.substr(std::min(path.size(), key.size() + 1));
  std::optional<bool> known;
  for (const ordered_json& one : at) {
    const std::optional<bool> leads =
        one.contains(key) ? leads_on(one[key], rest) : false;
    if (leads) known = *leads || known.value_or(false);
  }
  return known;
}

std::string text_of(const std::vector<NamedCells>& rows) {
  std::vector<std::string> columns;
  for (const NamedCells& row : rows) {
    for (const auto& [name, cell] : row) {
      if (std::ranges::find(columns, name) == columns.end()) {
        columns.push_back(name);
      }
    }
  }
  if (columns.empty()) return {};
  std::string text = csv_row(columns);
  for (const NamedCells& row : rows) {
    std::vector<std::string> cells(columns.size());
    for (const auto& [name, cell] : row) {
      const auto at = std::ranges::find(columns, name);
      cells[static_cast<std::size_t>(at - columns.begin())] = cell;
    }
    text += csv_row(cells);
  }
  return text;
}

std::vector<std::string> tables_of(const ordered_json& whole) {
  std::vector<std::string> names;
  for (const auto& [key, value] : whole.items()) {
    if (value.is_structured()) names.push_back(key);
  }
  return names;
}

}  // namespace

std::string csv_table(std::string_view json, std::string_view table) {
  const ordered_json whole = ordered_json::parse(json);
  const std::string first(table.substr(0, table.find('.')));
  const std::string_view rest =
      table.substr(std::min(table.size(), first.size() + 1));
  if (!whole.contains(first) || !whole[first].is_structured() ||
      !leads_on(whole[first], rest).value_or(true)) {
    throw NoSuchTable(
        fmt::format("there is no table \"{}\"", table),
        "--csv",
        fmt::format("there are {}", fmt::join(tables_of(whole), ", ")));
  }
  std::vector<NamedCells> rows;
  add_rows(rows, whole[first], rest, {});
  return text_of(rows);
}

}  // namespace tapfit::tui
