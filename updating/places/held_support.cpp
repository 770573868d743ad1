#include "updating/places/held_support.hpp"

#include "updating/structure/deck/constraint_axes.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace tapfit::updating {

using structure::ConstraintAxes;
using structure::Deck;

namespace {

using NamedComponents = std::pair<std::string, std::string>;

const std::array<NamedComponents, 5>& all_held() {
  static const std::array<NamedComponents, 5> all = {
      NamedComponents{"held", "123456"},
      NamedComponents{"held-translations", "123"},
      NamedComponents{"held-X", "1"},
      NamedComponents{"held-Y", "2"},
      NamedComponents{"held-Z", "3"}};
  return all;
}

std::string in_both(const std::string& a, const std::string& b) {
  std::string both;
  for (const char digit : a) {
    if (b.find(digit) != std::string::npos) both += digit;
  }
  return both;
}

void add_dofs(const Deck& deck,
              int node,
              const std::string& components,
              std::vector<int>& dofs) {
  const int first = 6 * static_cast<int>(deck.grid_index(node));
  for (const char digit : components) dofs.push_back(first + (digit - '1'));
}

}  // namespace

std::vector<std::string> held_variants() {
  std::vector<std::string> names;
  for (const auto& [name, components] : all_held()) names.push_back(name);
  return names;
}

std::string held_components(const std::string& variant) {
  const auto found =
      std::ranges::find(all_held(), variant, &NamedComponents::first);
  return found == all_held().end() ? std::string() : found->second;
}

bool is_held(const Location& where) {
  return !held_components(where.variant).empty();
}

std::vector<HeldGrid> newly_held(const Deck& deck, const Location& where) {
  const ConstraintAxes held = structure::constraint_axes(deck);
  const std::string wanted = held_components(where.variant);
  std::vector<HeldGrid> result;
  for (const int node : where.nodes) {
    const std::string known = held.held_in_basic(node);
    HeldGrid grid{node, {}};
    for (const char digit : wanted) {
      if (known.find(digit) == std::string::npos) grid.components += digit;
    }
    if (!grid.components.empty()) result.push_back(std::move(grid));
  }
  return result;
}

std::vector<int> held_dofs(const structure::RefinedDeck& mesh,
                           const Location& where) {
  std::map<int, std::string> fresh;
  for (const HeldGrid& grid : newly_held(mesh.deck, where)) {
    fresh[grid.node] = grid.components;
  }
  std::vector<int> dofs;
  for (const auto& [node, components] : fresh) {
    add_dofs(mesh.deck, node, components, dofs);
  }
  const auto known = structure::constraint_axes(mesh.deck);
  for (const auto& [node, ends] : mesh.between) {
    std::string shared = "123456";
    bool any = false;
    for (const int end : ends) {
      const auto own = fresh.find(end);
      any = any || own != fresh.end();
      shared = in_both(shared,
                       known.held_in_basic(end) +
                           (own == fresh.end() ? std::string() : own->second));
    }
    if (any) add_dofs(mesh.deck, node, shared, dofs);
  }
  std::ranges::sort(dofs);
  return dofs;
}

}  // namespace tapfit::updating
