#include "tui/screen/line_text.hpp"

#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {

std::string fitting(const std::vector<std::string>& wordings, int width) {
  const auto found = std::ranges::find_if(
      wordings,
      [width](const std::string& words) { return text_width(words) <= width; });
  if (found != wordings.end()) return *found;
  return wordings.empty() ? std::string() : wordings.back();
}

std::string listed(const std::string& heading,
                   const std::vector<std::string>& items,
                   const std::string& separator,
                   int width) {
  const auto rest = [&](std::size_t shown) {
    if (shown == items.size()) return std::string();
    return fmt::format(
        "{}+{}", shown == 0 ? "" : separator, items.size() - shown);
  };
  std::string words = heading;
  std::string best = heading + rest(0);
  for (std::size_t i = 0; i < items.size() && text_width(words) <= width; ++i) {
    words += (i == 0 ? "" : separator) + items[i];
    const std::string whole = words + rest(i + 1);
    if (text_width(whole) <= width) best = whole;
  }
  return best;
}

}  // namespace tapfit::tui
