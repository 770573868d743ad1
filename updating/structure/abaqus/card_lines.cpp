#include "updating/structure/abaqus/card_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {

std::string real_field(double value) {
  constexpr std::size_t widest = 16;
  if (value == 0.0) return "0.";
  std::string text;
  for (int digits = 17; digits > 1; --digits) {
    text = fmt::format("{:.{}g}", value, digits);
    // The shortest that is the same number.
    if (digits == 17) {
      std::string shortest = fmt::format("{}", value);
      if (shortest.size() < text.size()) text = std::move(shortest);
    }
    if (text.find('.') == std::string::npos) {
      text.insert(std::min(text.find('e'), text.size()), ".");
    }
    if (text.size() <= widest) break;
  }
  return text;
}

void CardLines::comment(const std::string& text, const Place& place) {
  lines_.push_back({"$ " + text, place.where, place.number});
}

void CardLines::card(const Place& place,
                     const std::string& name,
                     const std::vector<std::string>& fields) {
  constexpr std::size_t small = 8;
  const bool large = std::ranges::any_of(
      fields, [](const std::string& f) { return f.size() > small; });
  const std::size_t per_line = large ? 4 : 8;
  const std::size_t width = large ? 2 * small : small;
  std::size_t end = fields.size();
  while (end > 1 && fields[end - 1].empty()) --end;
  for (std::size_t at = 0; at < end; at += per_line) {
    std::string text = fmt::format(
        "{:<8}",
        at == 0 ? name + (large ? "*" : "") : std::string(large ? "*" : "+"));
    for (std::size_t k = at; k < std::min(at + per_line, end); ++k) {
      text += fmt::format("{:<{}}", fields[k], width);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    lines_.push_back({std::move(text), place.where, place.number});
  }
}

}  // namespace tapfit::structure
