#include "updating/structure/checks/doubled_parts.hpp"

#include "updating/structure/cards/listed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace tapfit::structure {
namespace {

using GridPair = std::pair<int, int>;

GridPair ordered(int a, int b) { return std::minmax(a, b); }

// Grids of elements that have a length.
std::set<int> meshed_grids(const Deck& deck) {
  std::set<int> grids;
  for (const Shell& e : deck.shells) {
    grids.insert(e.grids.begin(), e.grids.end());
  }
  for (const Solid& e : deck.solids) {
    grids.insert(e.grids.begin(), e.grids.end());
  }
  for (const Bar& e : deck.bars) grids.insert(e.grids.begin(), e.grids.end());
  for (const Rod& e : deck.rods) grids.insert(e.grids.begin(), e.grids.end());
  return grids;
}

// What springs, bushes, dashpots and rigid elements have between them.
std::set<GridPair> joined_grids(const Deck& deck) {
  std::set<GridPair> joined;
  for (const ScalarElement& e : deck.scalars) {
    joined.insert(ordered(e.grids[0], e.grids[1]));
  }
  for (const Bush& e : deck.bushes) {
    joined.insert(ordered(e.grids[0], e.grids[1]));
  }
  for (const RigidElement& e : deck.rigids) {
    for (const Dependent& d : e.dependents) {
      joined.insert(ordered(e.independent, d.grid));
    }
  }
  for (const Relation& e : deck.relations) {
    for (const RelationTerm& term : e.terms) {
      joined.insert(ordered(e.grid, term.grid));
    }
  }
  for (const MatrixTerm& term : deck.stiffness_terms) {
    joined.insert(ordered(term.grids[0], term.grids[1]));
  }
  return joined;
}

// Grids at one place, up to the last digits that programs print; those alone at
// theirs are left out.
std::vector<std::vector<int>> coincident(const Deck& deck) {
  Eigen::Vector3d low = deck.grids.front().position;
  Eigen::Vector3d high = low;
  for (const Grid& grid : deck.grids) {
    low = low.cwiseMin(grid.position);
    high = high.cwiseMax(grid.position);
  }
  const double cell = std::max(1e-6 * (high - low).norm(), 1e-12);
  std::map<std::array<long long, 3>, std::vector<int>> places;
  for (const Grid& grid : deck.grids) {
    std::array<long long, 3> at{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto k = static_cast<Eigen::Index>(c);
      at[c] = std::llround((grid.position(k) - low(k)) / cell);
    }
    places[at].push_back(grid.id);
  }
  std::vector<std::vector<int>> shared;
  for (auto& [at, grids] : places) {
    if (grids.size() > 1) shared.push_back(std::move(grids));
  }
  return shared;
}

// Those that something leads to from the first, over others between.
std::set<int> reached(const std::vector<int>& grids,
                      const std::set<GridPair>& joined) {
  std::set<int> found{grids.front()};
  for (std::size_t round = 1; round < grids.size(); ++round) {
    for (const int a : grids) {
      for (const int b : grids) {
        if (found.contains(a) && joined.contains(ordered(a, b)))
          found.insert(b);
      }
    }
  }
  return found;
}

std::string open_seams(const Deck& deck) {
  const std::set<GridPair> joined = joined_grids(deck);
  const std::set<int> meshed = meshed_grids(deck);
  std::vector<std::string> open;
  for (std::vector<int>& grids : coincident(deck)) {
    // One with elements first, where there is any.
    std::ranges::stable_partition(
        grids, [&](int grid) { return meshed.contains(grid); });
    const std::set<int> held = reached(grids, joined);
    for (std::size_t k = 1; k < grids.size(); ++k) {
      if (!meshed.contains(grids[k]) || held.contains(grids[k])) continue;
      open.push_back(fmt::format("{} and {}", grids.front(), grids[k]));
    }
  }
  if (open.empty()) return {};
  return fmt::format(
      "GRID {}: at one place, each with elements of its own and nothing "
      "between them: the model is open there; merge them, or join them with "
      "springs or an RBE2",
      listed(open));
}

std::string doubled_shells(const Deck& deck) {
  std::map<std::vector<int>, const Shell*> known;
  std::vector<std::string> doubled;
  for (const Shell& e : deck.shells) {
    std::vector<int> grids = e.grids;
    std::ranges::sort(grids);
    const auto [there, is_first] = known.try_emplace(std::move(grids), &e);
    if (is_first) continue;
    doubled.push_back(
        fmt::format("{} (on {})",
                    card_place(deck, e.where, fmt::format("shell {}", e.id)),
                    there->second->id));
  }
  if (doubled.empty()) return {};
  return fmt::format(
      "{}: on the same grids as another: stiffness and mass count twice; leave "
      "it so only if that is meant",
      listed(doubled));
}

}  // namespace

std::vector<std::string> doubled_part_warnings(const Deck& deck) {
  std::vector<std::string> texts;
  if (deck.grids.empty()) return texts;
  for (std::string text : {open_seams(deck), doubled_shells(deck)}) {
    if (!text.empty()) texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace tapfit::structure
