#include "updating/effects/point_effect.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace tapfit::effects {

std::vector<Location> PointEffect::places(const TestContext& context) const {
  std::vector<Location> result;
  if (context.deck == nullptr) return result;
  // A grid held in every translation cannot move, so nothing shows there.
  std::set<int> held;
  for (const structure::Constraint& c : context.deck->constraints) {
    const bool all = c.components.find('1') != std::string::npos &&
                     c.components.find('2') != std::string::npos &&
                     c.components.find('3') != std::string::npos;
    if (all) held.insert(c.grid);
  }
  for (const structure::Grid& grid : context.deck->grids) {
    if (grid.id < 0 || held.contains(grid.id)) continue;
    result.push_back({.node = grid.id});
  }
  return result;
}

namespace {

const std::string axes = "XYZ";

}  // namespace

DirectedEffect::DirectedEffect(std::string name, std::string words, Law law)
    : PointEffect({.name = std::move(name),
                   .words = std::move(words),
                   .sits = Sits::AlongAxis,
                   .law = law,
                   .forms = {"X", "Y", "Z"}}) {}

std::vector<Location> DirectedEffect::places(const TestContext& context) const {
  const std::vector<Location> grids = PointEffect::places(context);
  std::vector<Location> result = grids;
  for (const int component : context.components) {
    if (component == context.component) continue;
    for (Location where : grids) {
      where.variant = axes.substr(static_cast<std::size_t>(component - 1), 1);
      result.push_back(std::move(where));
    }
  }
  return result;
}

std::vector<InterfaceDof> DirectedEffect::interface_dofs(
    const Location& where, const TestContext& context, std::size_t) const {
  return {motion_of(where, component_of(where, context), context)};
}

int component_of(const Location& where, const TestContext& context) {
  if (where.variant.empty()) return context.component;
  return static_cast<int>(axes.find(where.variant)) + 1;
}

InterfaceDof motion_of(const Location& where,
                       int component,
                       const TestContext& context) {
  InterfaceDof motion{where.node, component};
  if (!where.at.empty()) {
    motion.between = updating::motion_between(*context.deck, where, component);
  }
  return motion;
}

std::vector<InterfaceDof> translations(const Location& where,
                                       const TestContext& context) {
  return {motion_of(where, 1, context),
          motion_of(where, 2, context),
          motion_of(where, 3, context)};
}

}  // namespace tapfit::effects
