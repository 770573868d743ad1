// Numbers as bulk data writes them.
#pragma once

#include <optional>
#include <string>

namespace tapfit::structure {

/// A real number as bulk data writes it: 1., 1.5-3, 1.5D-3, 7.E+10, 3.
/// Empty when the text is not a finite number.
[[nodiscard]] std::optional<double> parse_real(const std::string& text);

[[nodiscard]] std::optional<int> parse_integer(const std::string& text);

}  // namespace tapfit::structure
