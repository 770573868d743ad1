// Rows of comma separated values.
//
// Source: RFC 4180; rows end in '\n' alone.
#pragma once

#include <string>
#include <vector>

namespace tapfit::tui {

/// A row with its end. Cells that hold the separator, a quote or an end of line
/// are quoted.
/// @param separator ',' or, as spreadsheets take it from a clipboard, '\t'
[[nodiscard]] std::string csv_row(const std::vector<std::string>& cells,
                                  char separator = ',');

/// Eight significant digits; empty for what is no finite number.
[[nodiscard]] std::string csv_number(double value);

}  // namespace tapfit::tui
