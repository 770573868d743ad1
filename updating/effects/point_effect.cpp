#include "updating/effects/point_effect.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

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

std::vector<Where> DirectedEffect::places(const Setting& setting) const {
  const std::vector<Where> grids = PointEffect::places(setting);
  std::vector<Where> result = grids;
  for (const int component : setting.components) {
    if (component == setting.component) continue;
    for (Where where : grids) {
      where.variant = axes.substr(static_cast<std::size_t>(component - 1), 1);
      result.push_back(std::move(where));
    }
  }
  return result;
}

std::vector<ActedDof> DirectedEffect::acts_on(const Where& where,
                                              const Setting& setting,
                                              std::size_t) const {
  return {motion_of(where, component_of(where, setting), setting)};
}

int component_of(const Where& where, const Setting& setting) {
  if (where.variant.empty()) return setting.component;
  return static_cast<int>(axes.find(where.variant)) + 1;
}

ActedDof motion_of(const Where& where, int component, const Setting& setting) {
  ActedDof motion{where.node, component};
  if (!where.at.empty()) {
    motion.between = updating::motion_between(*setting.deck, where, component);
  }
  return motion;
}

std::vector<ActedDof> translations(const Where& where, const Setting& setting) {
  return {motion_of(where, 1, setting),
          motion_of(where, 2, setting),
          motion_of(where, 3, setting)};
}

}  // namespace tapfit::effects
