#include "updating/places/support_groups.hpp"

#include "updating/places/support_axes.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tapfit::updating {

std::map<int, std::set<int>> joined_grids(const structure::Deck& deck) {
  std::map<int, std::set<int>> result;
  const auto connect = [&result](int a, int b) {
    result[a].insert(b);
    result[b].insert(a);
  };
  for (const structure::Shell& shell : deck.shells) {
    const std::size_t n = shell.grids.size();
    for (std::size_t k = 0; k < n; ++k) {
      connect(shell.grids[k], shell.grids[(k + 1) % n]);
    }
  }
  for (const structure::Bar& bar : deck.bars) {
    connect(bar.grids[0], bar.grids[1]);
  }
  return result;
}

bool are_hubs(const structure::Deck& deck, const std::vector<int>& nodes) {
  std::set<int> leads;
  for (const structure::RigidElement& e : deck.rigids) {
    leads.insert(e.independent);
  }
  const std::map<int, std::set<int>> joined = joined_grids(deck);
  return std::ranges::all_of(nodes, [&](int node) {
    return leads.contains(node) && !joined.contains(node);
  });
}

namespace {

// Those of one solid: a held face is one support.
void join_solids(const structure::Deck& deck,
                 std::map<int, std::set<int>>& joined) {
  for (const structure::Solid& solid : deck.solids) {
    const std::vector<int> grids = solid.all_grids();
    for (const int grid : grids) {
      joined[grid].insert(grids.begin(), grids.end());
    }
  }
}

}  // namespace

std::vector<std::vector<int>> support_groups(const structure::Deck& deck) {
  std::map<int, std::set<int>> near = joined_grids(deck);
  join_solids(deck, near);
  const std::map<int, std::string> held = support_axes(deck).axes.held;
  std::set<int> done;
  std::vector<std::vector<int>> groups;
  for (const structure::Grid& grid : deck.grids) {
    if (!held.contains(grid.id) || done.contains(grid.id)) continue;
    std::vector<int> open = {grid.id};
    std::set<int> group;
    while (!open.empty()) {
      const int node = open.back();
      open.pop_back();
      if (!group.insert(node).second) continue;
      const auto it = near.find(node);
      if (it == near.end()) continue;
      for (const int next : it->second) {
        if (held.contains(next)) open.push_back(next);
      }
    }
    done.insert(group.begin(), group.end());
    groups.emplace_back(group.begin(), group.end());
  }
  return groups;
}

std::vector<std::vector<int>> support_choices(const structure::Deck& deck) {
  std::vector<std::vector<int>> choices = support_groups(deck);
  if (choices.size() < 2) return choices;
  std::vector<int> all;
  std::size_t count = 0;
  for (const std::vector<int>& group : choices) {
    if (are_hubs(deck, group)) continue;
    all.insert(all.end(), group.begin(), group.end());
    ++count;
  }
  if (count > 1) choices.push_back(std::move(all));
  return choices;
}

}  // namespace tapfit::updating
