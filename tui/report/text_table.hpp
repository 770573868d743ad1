// Plain text tables, columns as wide as their widest cell.
#pragma once

#include "tui/screen/number.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::tui {

/// A table of text: the first row is the heading.
class TextTable {
 public:
  /// @param heading one entry per column; a leading '<' sets the column to
  ///   the left (names), otherwise it is set to the right (numbers)
  explicit TextTable(const std::vector<std::string>& heading);

  /// @param row at most as many cells as the heading has; missing ones empty
  void add(std::vector<std::string> row);

  /// Lines indented by two spaces, no trailing blanks; each ends in '\n'.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  std::vector<bool> left_;
};

/// Characters shown by UTF-8 text (combining marks are not looked for).
[[nodiscard]] std::size_t shown_width(std::string_view text);

/// Four significant digits, for example "71.02e9" as "7.102e+10".
[[nodiscard]] std::string short_number(double value);

}  // namespace tapfit::tui
