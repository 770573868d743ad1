#include "updating/places/element_cells.hpp"

#include "updating/places/gathered.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

template <typename Elements>
void add_elements(const Deck& deck,
                  const Elements& elements,
                  std::vector<ElementCell>& cells) {
  for (const auto& e : elements) {
    ElementCell cell{{e.id}, e.property, Vector3d::Zero()};
    for (const int grid : e.grids) {
      cell.middle += deck.grid(grid).position;
    }
    cell.middle /= static_cast<double>(e.grids.size());
    cells.push_back(std::move(cell));
  }
}

}  // namespace

std::vector<ElementCell> element_cells(const Deck& deck) {
  std::vector<ElementCell> single;
  add_elements(deck, deck.shells, single);
  add_elements(deck, deck.bars, single);
  add_elements(deck, deck.rods, single);
  add_elements(deck, deck.solids, single);
  std::vector<Vector3d> middles;
  for (const ElementCell& cell : single) middles.push_back(cell.middle);
  std::vector<ElementCell> cells;
  for (const std::vector<std::size_t>& group : gathered(middles)) {
    std::map<int, ElementCell> of_property;
    for (const std::size_t k : group) {
      const ElementCell& one = single[k];
      ElementCell& cell =
          of_property
              .try_emplace(one.property,
                           ElementCell{{}, one.property, Vector3d::Zero()})
              .first->second;
      cell.elements.push_back(one.elements.front());
      cell.middle += one.middle;
    }
    for (auto& [property, cell] : of_property) {
      cell.middle /= static_cast<double>(cell.elements.size());
      std::ranges::sort(cell.elements);
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

}  // namespace tapfit::updating
