#include "tui/line_text.hpp"

#include "tui/text.hpp"

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
  std::vector<std::string> wordings;
  for (std::size_t shown = items.size() + 1; shown-- > 0;) {
    std::string words = heading;
    for (std::size_t i = 0; i < shown; ++i) {
      words += (i == 0 ? "" : separator) + items[i];
    }
    if (shown < items.size()) {
      words += fmt::format(
          "{}+{}", shown == 0 ? "" : separator, items.size() - shown);
    }
    wordings.push_back(std::move(words));
  }
  return fitting(wordings, width);
}

}  // namespace tapfit::tui
