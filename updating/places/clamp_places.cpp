#include "updating/places/clamp_places.hpp"

#include "updating/places/shell_edges.hpp"
#include "updating/structure/deck/constraint_axes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::ConstraintAxes;
using structure::Deck;
using GridSet = std::set<int>;
using Joined = std::map<int, GridSet>;  // grid -> those beside it

// Of the box's diagonal: on one plane, as far as a drawing is.
constexpr double on_plane = 1e-3;

// An edge goes on where it turns by less than 45 degrees: around a hole of
// eight elements, not around a corner.
constexpr double goes_on = 0.7;

// Of so many free edges the longest.
constexpr std::size_t most_edges = 12;

// All grids of the structure's elements, and which are in one with which.
Joined joined_by_elements(const Deck& deck) {
  Joined joined;
  const auto join = [&joined](const auto& grids) {
    for (const int a : grids) {
      GridSet& beside = joined[a];
      beside.insert(grids.begin(), grids.end());
      beside.erase(a);
    }
  };
  for (const structure::Shell& e : deck.shells) join(e.all_grids());
  for (const structure::Solid& e : deck.solids) join(e.all_grids());
  for (const structure::Bar& e : deck.bars) join(e.grids);
  for (const structure::Rod& e : deck.rods) join(e.grids);
  return joined;
}

// What of a set hangs together.
std::vector<GridSet> connected_parts(const GridSet& whole,
                                     const Joined& joined) {
  std::vector<GridSet> parts;
  GridSet left = whole;
  while (!left.empty()) {
    std::vector<int> open = {*left.begin()};
    left.erase(left.begin());
    GridSet& part = parts.emplace_back();
    while (!open.empty()) {
      const int grid = open.back();
      open.pop_back();
      part.insert(grid);
      const auto beside = joined.find(grid);
      if (beside == joined.end()) continue;
      for (const int next : beside->second) {
        if (left.erase(next) > 0) open.push_back(next);
      }
    }
  }
  return parts;
}

// Grids on either end of the structure along each axis; none along one in which
// it does not extend.
std::vector<std::array<GridSet, 2>> ends_of(const Deck& deck,
                                            const Joined& joined) {
  Eigen::AlignedBox3d box;
  for (const auto& [grid, beside] : joined) {
    box.extend(deck.grid(grid).position);
  }
  std::vector<std::array<GridSet, 2>> ends;
  if (box.isEmpty()) return ends;
  const double near = on_plane * box.diagonal().norm();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (box.sizes()(axis) <= 2.0 * near) continue;
    std::array<GridSet, 2>& both = ends.emplace_back();
    for (const auto& [grid, beside] : joined) {
      const double x = deck.grid(grid).position(axis);
      if (x <= box.min()(axis) + near) both[0].insert(grid);
      if (x >= box.max()(axis) - near) both[1].insert(grid);
    }
  }
  return ends;
}

// Free edges of shells from one corner to the next, and these corners.
struct Rims {
  std::vector<GridSet> runs;  // longest first
  GridSet corners;
};

Rims rims_of(const Deck& deck) {
  Joined beside;
  for (const auto& [edge, shells] : edges_of(deck)) {
    if (shells.size() != 1) continue;
    beside[edge[0]].insert(edge[1]);
    beside[edge[1]].insert(edge[0]);
  }
  Rims rims;
  GridSet between;  // where an edge goes on
  for (const auto& [grid, ends] : beside) {
    const Vector3d x = deck.grid(grid).position;
    const bool two = ends.size() == 2;
    const Vector3d in = x - deck.grid(*ends.begin()).position;
    const Vector3d out = deck.grid(*ends.rbegin()).position - x;
    const bool on = two && in.dot(out) > goes_on * in.norm() * out.norm();
    (on ? between : rims.corners).insert(grid);
  }
  rims.runs = connected_parts(between, beside);
  for (GridSet& run : rims.runs) {
    const GridSet inner = run;
    for (const int grid : inner) {
      run.insert(beside[grid].begin(), beside[grid].end());
    }
  }
  // Of one element, from corner to corner.
  for (const int a : rims.corners) {
    for (const int b : beside[a]) {
      if (a < b && rims.corners.contains(b)) rims.runs.push_back({a, b});
    }
  }
  const auto span = [&deck](const GridSet& run) {
    Eigen::AlignedBox3d box;
    for (const int grid : run) box.extend(deck.grid(grid).position);
    return box.diagonal().norm();
  };
  std::ranges::stable_sort(rims.runs, std::greater<>{}, span);
  return rims;
}

GridSet bar_ends(const Deck& deck, const Joined& joined) {
  GridSet ends;
  for (const structure::Bar& bar : deck.bars) {
    for (const int grid : bar.grids) {
      if (joined.at(grid).size() == 1) ends.insert(grid);
    }
  }
  return ends;
}

GridSet common_grids(const GridSet& a, const GridSet& b) {
  GridSet both;
  std::ranges::set_intersection(a, b, std::inserter(both, both.end()));
  return both;
}

GridSet all_of_both(const GridSet& a, const GridSet& b) {
  GridSet all = a;
  all.insert(b.begin(), b.end());
  return all;
}

// The sets that are worth trying, each once.
class Clamps {
 public:
  Clamps(const Deck& deck, const Joined& joined) {
    const ConstraintAxes held = structure::constraint_axes(deck);
    for (const auto& [grid, beside] : joined) {
      const auto own = held.held.find(grid);
      const bool wholly = own != held.held.end() && own->second.size() >= 6;
      if (!wholly) loose_.insert(grid);
    }
  }

  void take(const GridSet& grids) {
    const GridSet fresh = common_grids(grids, loose_);
    if (fresh.empty() || 2 * fresh.size() > loose_.size()) return;
    std::vector<int> place(fresh.begin(), fresh.end());
    if (known_.insert(place).second) places_.push_back(std::move(place));
  }

  [[nodiscard]] std::vector<std::vector<int>> places() && {
    return std::move(places_);
  }

 private:
  GridSet loose_;
  std::set<std::vector<int>> known_;
  std::vector<std::vector<int>> places_;
};

}  // namespace

std::vector<std::vector<int>> clamp_places(const Deck& deck) {
  const Joined joined = joined_by_elements(deck);
  const auto ends = ends_of(deck, joined);
  const Rims rims = rims_of(deck);
  Clamps clamps(deck, joined);
  for (const auto& both : ends) {
    for (const GridSet& end : both) {
      clamps.take(end);
      for (const GridSet& part : connected_parts(end, joined))
        clamps.take(part);
    }
    clamps.take(all_of_both(both[0], both[1]));
  }
  for (std::size_t k = 0; k < std::min(most_edges, rims.runs.size()); ++k) {
    clamps.take(rims.runs[k]);
  }
  for (const int end : bar_ends(deck, joined)) clamps.take({end});
  GridSet corners;
  for (const auto& both : ends) {
    for (const GridSet& end : both) {
      const GridSet here = common_grids(rims.corners, end);
      corners.insert(here.begin(), here.end());
      if (here.size() > 1) clamps.take(here);
    }
  }
  if (corners.size() > 1) clamps.take(corners);
  return std::move(clamps).places();
}

}  // namespace tapfit::updating
