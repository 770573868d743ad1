#include "tui/workbench/pair_words.hpp"

#include <charconv>

namespace tapfit::tui {

std::optional<modal::Pair> parse_pair(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return std::nullopt;
  const auto mode = [](const std::string& part) -> std::optional<int> {
    int value = 0;
    const char* end = part.data() + part.size();
    const auto [at, fault] = std::from_chars(part.data(), end, value);
    if (fault != std::errc() || at != end || value < 1) return std::nullopt;
    return value - 1;
  };
  const std::optional<int> first = mode(text.substr(0, colon));
  const std::string rest = text.substr(colon + 1);
  const std::optional<int> second = rest == "none" ? -1 : mode(rest);
  if (!first || !second) return std::nullopt;
  return modal::Pair{*first, *second, 0.0};
}

}  // namespace tapfit::tui
