#include "updating/structure/edit/move_elements.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace tapfit::structure {
namespace {

// Positions of the MSC Nastran Quick Reference Guide, the name at 0.
constexpr std::size_t first_grid = 3;

std::size_t grid_count(const std::string& name) {
  if (name == "CQUAD4" || name == "CQUADR" || name == "CSHEAR") return 4;
  if (name == "CTRIA3" || name == "CTRIAR") return 3;
  return name == "CBAR" || name == "CBEAM" ? 2 : 0;
}

}  // namespace

CardEdit move_elements(const GridMoves& moves, const WeakenCards& weak) {
  return [&moves, &weak](const Card& card) -> std::optional<std::vector<Card>> {
    const std::size_t count = grid_count(card.name());
    if (count == 0 || card.fields.size() < 2) return std::nullopt;
    const auto element = moves.find(parse_integer(card.fields[1]).value_or(0));
    if (element == moves.end()) return std::nullopt;
    Card own = weak.moved(card).value_or(card);
    const std::size_t end = std::min(first_grid + count, own.fields.size());
    for (std::size_t at = first_grid; at < end; ++at) {
      const auto grid =
          element->second.find(parse_integer(own.fields[at]).value_or(0));
      if (grid == element->second.end()) continue;
      own.fields[at] = fmt::format("{}", grid->second);
    }
    return std::vector<Card>{std::move(own)};
  };
}

}  // namespace tapfit::structure
