#include "updating/places/support_axes.hpp"

#include <algorithm>
#include <map>

namespace tapfit::updating {

SupportAxes support_axes(const structure::Deck& deck) {
  constexpr double nearly_all = 0.9;
  SupportAxes result{structure::constraint_axes(deck), {}};
  const auto grids = std::ranges::count_if(
      deck.grids,
      [](const structure::Grid& grid) { return grid.id > 0 && !grid.scalar; });
  std::map<char, double> count;
  for (const auto& [grid, unused] : result.axes.held) {
    for (const char digit : result.axes.held_in_basic(grid)) ++count[digit];
  }
  for (const auto& [digit, held] : count) {
    if (held >= nearly_all * static_cast<double>(grids)) {
      result.everywhere += digit;
    }
  }
  if (result.everywhere.empty()) return result;
  auto& held = result.axes.held;
  for (auto it = held.begin(); it != held.end();) {
    if (!result.axes.turned.contains(it->first)) {
      std::erase_if(it->second, [&result](char digit) {
        return result.everywhere.find(digit) != std::string::npos;
      });
    }
    it = it->second.empty() ? held.erase(it) : std::next(it);
  }
  return result;
}

}  // namespace tapfit::updating
