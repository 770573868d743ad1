#include "tui/report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tapfit::tui {

namespace {

std::string padded(const std::string& cell, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, shown_width(cell)), ' ');
  return left ? cell + blanks : blanks + cell;
}

}  // namespace

TextTable::TextTable(const std::vector<std::string>& heading) {
  std::vector<std::string> names;
  for (const std::string& name : heading) {
    left_.push_back(name.starts_with('<'));
    names.push_back(name.substr(left_.back() ? 1 : 0));
  }
  rows_.push_back(std::move(names));
}

void TextTable::add(std::vector<std::string> row) {
  assert(row.size() <= left_.size());
  row.resize(left_.size());
  rows_.push_back(std::move(row));
}

std::string TextTable::text() const {
  std::vector<std::size_t> width(left_.size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      width[column] = std::max(width[column], shown_width(row[column]));
    }
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      line += "  " + padded(row[column], width[column], left_[column]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::size_t shown_width(std::string_view text) {
  // Continuation bytes of UTF-8 are 10xxxxxx.
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
      }));
}

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

}  // namespace tapfit::tui
