#include "updating/structure/cards/listed.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {

std::string listed(const std::vector<std::string>& items, std::size_t shown) {
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, items.size()); ++i) {
    if (i > 0) text += ", ";
    text += items[i];
  }
  if (items.size() > shown) {
    text += fmt::format(" and {} more", items.size() - shown);
  }
  return text;
}

}  // namespace tapfit::structure
