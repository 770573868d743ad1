#include "updating/structure/cards/bulk_numbers.hpp"

#include <charconv>
#include <cmath>

namespace tapfit::structure {

std::optional<double> parse_real(const std::string& text) {
  std::string number;
  for (const char raw : text) {
    const char c = (raw == 'd' || raw == 'D' || raw == 'e') ? 'E' : raw;
    const bool sign = c == '+' || c == '-';
    if (sign && !number.empty() && number.back() != 'E') number += 'E';
    if (c == '+' && (number.empty() || number.back() == 'E')) continue;
    number += c;
  }
  double value = 0.0;
  const char* end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<int> parse_integer(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  int value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || begin == end) return std::nullopt;
  return value;
}

}  // namespace tapfit::structure
