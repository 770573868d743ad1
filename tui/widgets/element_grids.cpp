#include "tui/widgets/element_grids.hpp"

#include <set>

namespace tapfit::tui {

std::vector<int> element_grids(const structure::Deck& deck,
                               const std::vector<int>& elements) {
  const std::set<int> wanted(elements.begin(), elements.end());
  std::set<int> grids;
  const auto take = [&](const auto& kind) {
    for (const auto& element : kind) {
      if (!wanted.contains(element.id)) continue;
      grids.insert(element.grids.begin(), element.grids.end());
    }
  };
  take(deck.shells);
  take(deck.solids);
  take(deck.bars);
  take(deck.rods);
  return {grids.begin(), grids.end()};
}

}  // namespace tapfit::tui
