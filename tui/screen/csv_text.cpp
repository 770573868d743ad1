#include "tui/screen/csv_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::tui {
namespace {

std::string quoted(const std::string& cell) {
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + "\"";
}

}  // namespace

std::string csv_row(const std::vector<std::string>& cells, char separator) {
  const std::string special{separator, '"', '\n', '\r'};
  std::string row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) row += separator;
    const bool plain = cells[i].find_first_of(special) == std::string::npos;
    row += plain ? cells[i] : quoted(cells[i]);
  }
  return row + "\n";
}

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.8g}", value) : std::string();
}

}  // namespace tapfit::tui
