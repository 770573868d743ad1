#include "updating/element_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// In sizes of the element in the middle. Half steps of an area: what lies
// between two of them is told apart by the fit no better.
constexpr std::array<double, 7> reach = {0.0, 1.1, 1.6, 2.3, 3.3, 4.7, 6.6};

template <typename Grids>
ElementCentre centre_of(const Deck& deck,
                        int id,
                        int property,
                        const Grids& grids) {
  ElementCentre centre{id, property, Vector3d::Zero(), 0.0};
  for (const int grid : grids) {
    centre.position += deck.grids[deck.grid_index(grid)].position;
  }
  centre.position /= static_cast<double>(grids.size());
  double around = 0.0;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    around += (deck.grids[deck.grid_index(grids[k])].position -
               deck.grids[deck.grid_index(grids[(k + 1) % grids.size()])]
                   .position)
                  .norm();
  }
  centre.size = around / static_cast<double>(grids.size());
  return centre;
}

}  // namespace

std::vector<ElementCentre> element_centres(const Deck& deck) {
  std::vector<ElementCentre> result;
  for (const structure::Shell& e : deck.shells) {
    result.push_back(centre_of(deck, e.id, e.property, e.grids));
  }
  for (const structure::Bar& e : deck.bars) {
    result.push_back(centre_of(deck, e.id, e.property, e.grids));
  }
  return result;
}

std::vector<std::vector<int>> element_patches(const Deck& deck) {
  const std::vector<ElementCentre> centres = element_centres(deck);
  std::set<std::vector<int>> seen;
  std::vector<std::vector<int>> patches;
  const auto take = [&](std::vector<int> ids) {
    // Most of the structure is not a local loss but another modulus.
    if (2 * ids.size() > centres.size() && ids.size() > 1) return;
    std::sort(ids.begin(), ids.end());
    if (seen.insert(ids).second) patches.push_back(std::move(ids));
  };
  for (const double sizes : reach) {
    for (const ElementCentre& middle : centres) {
      std::vector<int> ids;
      for (const ElementCentre& e : centres) {
        if ((e.position - middle.position).norm() <=
            sizes * middle.size * (1.0 + 1e-9)) {
          ids.push_back(e.id);
        }
      }
      take(std::move(ids));
    }
  }
  std::map<int, std::vector<int>> of_property;
  for (const ElementCentre& e : centres) {
    of_property[e.property].push_back(e.id);
  }
  for (auto& [property, ids] : of_property) take(std::move(ids));
  return patches;
}

}  // namespace tapfit::updating
