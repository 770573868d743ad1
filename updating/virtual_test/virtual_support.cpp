#include "updating/virtual_test/virtual_support.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/places/support_axes.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

constexpr const char* rotations = "456";

std::set<int> held_grids(const structure::Deck& deck) {
  const structure::ConstraintAxes axes = support_axes(deck).axes;
  std::set<int> held;
  for (const auto& [grid, components] : axes.held) {
    const bool turns =
        axes.held_in_basic(grid).find_first_of(rotations) == std::string::npos;
    if (!turns) held.insert(grid);
  }
  return held;
}

// The basic axis along which the grids lie.
int line_axis(const structure::Deck& deck, const std::set<int>& held) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high = -low;
  for (const structure::Grid& grid : deck.grids) {
    if (!held.contains(grid.id)) continue;
    low = low.cwiseMin(grid.position);
    high = high.cwiseMax(grid.position);
  }
  Eigen::Vector3d extent = high - low;
  Eigen::Index axis = 0;
  const double length = held.size() < 2 ? 0.0 : extent.maxCoeff(&axis);
  extent(axis) = 0.0;
  if (!(length > 0.0) || extent.maxCoeff() > 1e-6 * length) {
    throw InputError("the clamped grids form no line along an axis",
                     "soft-support",
                     "Take a structure that is clamped along one straight "
                     "edge, or leave the effect out.");
  }
  return static_cast<int>(axis);
}

// Grids next to each other, by edges between them; none of a frame's feet.
std::set<std::pair<int, int>> sides_of(const structure::Deck& deck,
                                       const std::set<int>& held) {
  std::set<std::pair<int, int>> sides;
  for (const structure::Shell& shell : deck.shells) {
    for (std::size_t k = 0; k < shell.grids.size(); ++k) {
      const int a = shell.grids[k];
      const int b = shell.grids[(k + 1) % shell.grids.size()];
      if (held.contains(a) && held.contains(b)) {
        sides.insert(std::minmax(a, b));
      }
    }
  }
  return sides;
}

}  // namespace

SupportEdge support_edge(const structure::Deck& deck) {
  const std::set<int> held = held_grids(deck);
  SupportEdge edge;
  const int axis = line_axis(deck, held);
  edge.turns = {4 + axis};
  const auto sides = sides_of(deck, held);
  if (sides.empty()) {
    edge.turns = {4, 5, 6};
    for (const int foot : held) edge.length_of[foot] = 1.0;
  }
  for (const auto& [a, b] : sides) {
    const double half = 0.5 * (deck.grids[deck.grid_index(a)].position -
                               deck.grids[deck.grid_index(b)].position)
                                  .norm();
    edge.length_of[a] += half;
    edge.length_of[b] += half;
  }
  const auto along = [&deck, axis](int grid) {
    return deck.grids[deck.grid_index(grid)].position(axis);
  };
  const auto [first, last] =
      std::ranges::minmax(held, {}, [&along](int grid) { return along(grid); });
  for (const int grid : held) {
    edge.at[grid] = (along(grid) - along(first)) / (along(last) - along(first));
  }
  return edge;
}

}  // namespace tapfit::updating
