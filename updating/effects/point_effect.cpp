#include "updating/effects/point_effect.hpp"

#include <algorithm>
#include <set>

namespace tapfit::effects {

std::vector<Where> PointEffect::places(const Setting& setting) const {
  std::vector<Where> result;
  if (setting.deck == nullptr) return result;
  // A grid held in every translation cannot move, so nothing shows there.
  std::set<int> held;
  for (const structure::Constraint& c : setting.deck->constraints) {
    const bool all = c.components.find('1') != std::string::npos &&
                     c.components.find('2') != std::string::npos &&
                     c.components.find('3') != std::string::npos;
    if (all) held.insert(c.grid);
  }
  for (const structure::Grid& grid : setting.deck->grids) {
    if (held.contains(grid.id)) continue;
    Where where;
    where.node = grid.id;
    result.push_back(where);
  }
  return result;
}

std::vector<ActedDof> translations(int node) {
  return {{node, 1, 1.0}, {node, 2, 1.0}, {node, 3, 1.0}};
}

}  // namespace tapfit::effects
