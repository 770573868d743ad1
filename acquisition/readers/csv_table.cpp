#include "acquisition/readers/csv_table.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/units.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/readers/clock_times.hpp"
#include "acquisition/readers/time_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

namespace tapfit::acquisition {
namespace {

struct Layout {
  char separator = ',';
  bool decimal_comma = false;
};

struct Text {
  std::string name;
  std::vector<std::string> lines;
  Layout layout;
};

std::string trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\"");
  if (first == std::string_view::npos) return {};
  const std::size_t last = text.find_last_not_of(" \t\"");
  return std::string(text.substr(first, last - first + 1));
}

// Fields of a line; a separator inside quotes does not separate.
std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> fields;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != separator)) continue;
    fields.push_back(trim(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  return fields;
}

std::optional<double> to_number(std::string field, const Layout& layout) {
  if (layout.decimal_comma) std::replace(field.begin(), field.end(), ',', '.');
  // Fortran's exponents.
  std::ranges::replace_if(
      field, [](char c) { return c == 'D' || c == 'd'; }, 'e');
  const char* begin = field.data();
  const char* end = begin + field.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0.0;
  const auto [rest, fault] = std::from_chars(begin, end, value);
  if (fault != std::errc{} || rest != end) return std::nullopt;
  return value;
}

bool is_comment(const std::string& line) {
  const std::string text = trim(line);
  return text.empty() || text[0] == '#' || text[0] == '%' ||
         text.starts_with("//");
}

// Judged by a line in the middle of the file, which is surely data.
Layout find_layout(const std::vector<std::string>& lines) {
  std::size_t at = lines.size() / 2;
  while (at + 1 < lines.size() && is_comment(lines[at])) ++at;
  const std::string& line = lines[at];
  const bool comma = line.find(',') != std::string::npos;
  const bool point = line.find('.') != std::string::npos;
  for (const char separator : {';', '\t'}) {
    if (line.find(separator) != std::string::npos) {
      return {separator, comma && !point};
    }
  }
  return {',', false};
}

// Text in two bytes a character: a mark in front, or zeros in the first line.
void refuse_utf16(const Text& text) {
  const std::string& first = text.lines.front();
  if (!first.starts_with("\xFF\xFE") && !first.starts_with("\xFE\xFF") &&
      first.find('\0') == std::string::npos) {
    return;
  }
  throw InputError("is UTF-16 text, or no text",
                   text.name,
                   "save it as UTF-8 (or ASCII) text");
}

// Some old programs end lines by a carriage return alone.
void split_at_returns(std::vector<std::string>& lines) {
  if (lines.size() != 1) return;
  const std::string whole = std::move(lines.front());
  lines.clear();
  for (std::size_t at = 0; at <= whole.size();) {
    const std::size_t end = std::min(whole.find('\r', at), whole.size());
    lines.push_back(whole.substr(at, end - at));
    at = end + 1;
  }
}

// Asked for now and then.
constexpr std::size_t lines_at_once = 1U << 14U;

Text read_lines(const std::filesystem::path& file,
                const Progress& progress = {}) {
  std::ifstream stream = open_input(file, most_table_bytes());
  if (!stream) {
    throw InputError("cannot be opened", file.string(), "correct the path");
  }
  Text text{file.string(), {}, {}};
  std::string line;
  while (std::getline(stream, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (text.lines.empty() && line.starts_with("\xEF\xBB\xBF")) {
      line.erase(0, 3);
    }
    text.lines.push_back(line);
    if (text.lines.size() % lines_at_once == 0) progress("reading", 0.0);
  }
  if (!text.lines.empty()) refuse_utf16(text);
  split_at_returns(text.lines);
  while (!text.lines.empty() && trim(text.lines.back()).empty()) {
    text.lines.pop_back();
  }
  if (text.lines.empty()) {
    throw InputError("is empty", text.name, "export the measurement again");
  }
  text.layout = find_layout(text.lines);
  return text;
}

bool is_data(const Text& text, std::size_t line) {
  if (line >= text.lines.size()) return false;
  const std::vector<std::string> fields =
      split(text.lines[line], text.layout.separator);
  const std::size_t count = std::min<std::size_t>(2, fields.size());
  return std::all_of(fields.begin(),
                     fields.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](const std::string& f) {
                       return to_number(f, text.layout) || seconds_of_day(f) ||
                              is_date(f);
                     });
}

std::size_t first_data_line(const Text& text, const CsvOptions& options) {
  if (options.skip_lines) {
    if (*options.skip_lines < text.lines.size()) return *options.skip_lines;
    throw InputError(
        fmt::format("ends with line {}, before any row", text.lines.size()),
        text.name,
        "skip fewer lines");
  }
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    const bool last = i + 1 == text.lines.size();
    if (is_data(text, i) && (last || is_data(text, i + 1))) return i;
  }
  throw InputError("holds no rows of numbers",
                   text.name,
                   "export it with a row of numbers for each sample, separated "
                   "by commas, semicolons or tabs");
}

// Volts and seconds are what a recorder's columns are in besides.
bool is_unit(const std::string& field) {
  return find_unit(field) || field == "V" || field == "mV" || seconds_in(field);
}

// "time_ms", "Zeit / ms": of times alone, since names may end so, too.
void take_time_unit_off(CsvColumn& column) {
  const std::size_t at = column.name.find_last_of(" _/,");
  const std::size_t end = column.name.find_first_of(" _/,");
  if (at == std::string::npos || !seconds_in(column.name.substr(at + 1))) {
    return;
  }
  const std::string time = column.name.substr(0, end);
  constexpr auto times = std::to_array<std::string_view>(
      {"t", "T", "time", "Time", "TIME", "zeit", "Zeit", "ZEIT"});
  if (std::ranges::count(times, time) == 0) return;
  if (column.unit.empty()) column.unit = column.name.substr(at + 1);
  column.name = time;
}

// "a [g]" or "a (g)" taken apart.
void take_unit_off(CsvColumn& column) {
  const std::size_t open = column.name.find_last_of("[(");
  if (open == std::string::npos) take_time_unit_off(column);
  if (open == std::string::npos || column.name.size() < open + 3) return;
  const char close = column.name[open] == '[' ? ']' : ')';
  if (column.name.back() != close) return;
  const std::string unit =
      column.name.substr(open + 1, column.name.size() - open - 2);
  if (column.unit.empty()) column.unit = unit;
  column.name = trim(column.name.substr(0, open));
}

// The nearest lines above the numbers tell most.
CsvColumn describe_column(const Text& text, std::size_t data, std::size_t k) {
  CsvColumn column{std::to_string(k + 1), {}, {}};
  for (std::size_t line = data; line-- > 0 && column.name.empty();) {
    const std::vector<std::string> fields =
        split(printable(text.lines[line]), text.layout.separator);
    if (k >= fields.size() || fields[k].empty()) continue;
    if (is_unit(fields[k])) {
      if (column.unit.empty()) column.unit = fields[k];
    } else if (!to_number(fields[k], text.layout)) {
      column.name = fields[k];
    }
  }
  take_unit_off(column);
  const std::vector<std::string> row =
      split(text.lines[data], text.layout.separator);
  if (k < row.size() && seconds_of_day(row[k])) column.unit = "s";
  return column;
}

// Position of a column: by name in the header line nearest to the data that
// has it, by its name without a unit, else by number.
std::size_t find_column(const Text& text,
                        std::size_t data,
                        const std::string& column) {
  for (std::size_t line = data; line-- > 0;) {
    const std::vector<std::string> fields =
        split(as_utf8(text.lines[line]), text.layout.separator);
    const auto found = std::find(fields.begin(), fields.end(), column);
    if (found != fields.end()) {
      return static_cast<std::size_t>(found - fields.begin());
    }
  }
  const std::size_t width =
      split(text.lines[data], text.layout.separator).size();
  for (std::size_t k = 0; k < width; ++k) {
    if (describe_column(text, data, k).name == column) return k;
  }
  std::size_t number = 0;
  const char* end = column.data() + column.size();
  const auto [rest, fault] = std::from_chars(column.data(), end, number);
  if (fault == std::errc{} && rest == end && number >= 1 && number <= width) {
    return number - 1;
  }
  throw InputError(
      fmt::format("there is no column \"{}\"", column),
      text.name,
      fmt::format("give a name of the header or a number from 1 to {}", width));
}

}  // namespace

std::vector<CsvColumn> list_csv_columns(const std::filesystem::path& file,
                                        const CsvOptions& options) {
  const Text text = read_lines(file);
  const std::size_t data = first_data_line(text, options);
  const std::vector<std::string> fields =
      split(text.lines[data], text.layout.separator);
  std::vector<CsvColumn> columns;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    if (!to_number(fields[k], text.layout) && !seconds_of_day(fields[k])) {
      continue;
    }
    columns.push_back(describe_column(text, data, k));
  }
  return columns;
}

CsvTable read_csv_table(const std::filesystem::path& file,
                        const std::vector<std::string>& columns,
                        const CsvOptions& options,
                        const Progress& progress) {
  const Text text = read_lines(file, progress);
  const std::size_t data = first_data_line(text, options);
  CsvTable table;
  std::vector<std::size_t> positions;
  for (const std::string& column : columns) {
    const std::size_t at = find_column(text, data, column);
    positions.push_back(at);
    const std::string unit = describe_column(text, data, at).unit;
    table.units.push_back(is_unit(unit) ? unit : "");
  }
  std::vector<ClockColumn> clocks(columns.size());
  Eigen::MatrixXd& values = table.values;
  values.resize(static_cast<Eigen::Index>(text.lines.size() - data),
                static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = data; i < text.lines.size(); ++i) {
    if (i % lines_at_once == 0) progress("reading", 0.5);
    const std::vector<std::string> fields =
        split(text.lines[i], text.layout.separator);
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const std::size_t at = positions[k];
      const std::string field = at < fields.size() ? fields[at] : "";
      std::optional<double> value = to_number(field, text.layout);
      if (!value) value = clocks[k].next(field);
      if (!value || !std::isfinite(*value)) {
        throw InputError(fmt::format("\"{}\" is no finite number", field),
                         fmt::format("{}:{}:{}", text.name, i + 1, at + 1),
                         "correct the cell, or export the measurement again");
      }
      values(static_cast<Eigen::Index>(i - data),
             static_cast<Eigen::Index>(k)) = *value;
    }
  }
  return table;
}

Eigen::MatrixXd read_csv_columns(const std::filesystem::path& file,
                                 const std::vector<std::string>& columns,
                                 const CsvOptions& options) {
  return read_csv_table(file, columns, options).values;
}

CsvHeader read_csv_header(const std::filesystem::path& file) {
  const Text text = read_lines(file);
  const auto fields_of = [&](std::size_t line) {
    return split(as_utf8(text.lines[line]), text.layout.separator);
  };
  std::size_t at = 0;
  while (at + 1 < text.lines.size() && is_comment(text.lines[at])) ++at;
  CsvHeader header{at + 1, fields_of(at), {}, at + 1, 0};
  const std::size_t below = at + 1;
  if (below < text.lines.size() && !is_comment(text.lines[below])) {
    std::vector<std::string> fields = fields_of(below);
    const bool none = std::ranges::none_of(fields, [&](const std::string& f) {
      return to_number(f, text.layout).has_value();
    });
    if (none) {
      header.units = std::move(fields);
      ++header.rows_from;
    }
  }
  while (header.rows_from < text.lines.size() &&
         is_comment(text.lines[header.rows_from])) {
    ++header.rows_from;
  }
  header.rows = text.lines.size() - header.rows_from;
  return header;
}

}  // namespace tapfit::acquisition
