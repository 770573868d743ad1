#include "updating/places/between_grids.hpp"

#include "updating/places/element_shapes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// An element of two, three or four grids.
using Corners = std::vector<int>;

// Off the element by more than this part of a side it is on another one.
std::optional<Shapes> shapes_within(const std::vector<Vector3d>& x,
                                    const Vector3d& at) {
  constexpr double off = 1e-3;
  std::optional<Shapes> shapes = shapes_at(x, at);
  if (shapes && shapes->off > off * (x[1] - x[0]).norm()) return std::nullopt;
  return shapes;
}

// Elements that a grid is a corner of.
std::vector<Corners> elements_at(const Deck& deck, int node) {
  std::vector<Corners> found;
  for (const structure::Shell& e : deck.shells) {
    if (std::ranges::find(e.grids, node) != e.grids.end()) {
      found.push_back(e.grids);
    }
  }
  for (const structure::Bar& e : deck.bars) {
    if (std::ranges::find(e.grids, node) != e.grids.end()) {
      found.emplace_back(e.grids.begin(), e.grids.end());
    }
  }
  return found;
}

int nearest_grid(const Deck& deck, const Vector3d& at) {
  int nearest = 0;
  double least = 1e300;
  for (const structure::Grid& grid : deck.grids) {
    const double far = (grid.position - at).norm();
    if (grid.id < 0 || far >= least) continue;
    least = far;
    nearest = grid.id;
  }
  return nearest;
}

// Grids that share a side with one.
std::set<int> joined_to(const Deck& deck, int node) {
  std::set<int> joined;
  for (const Corners& element : elements_at(deck, node)) {
    const auto n = element.size();
    const auto own = static_cast<std::size_t>(std::ranges::find(element, node) -
                                              element.begin());
    joined.insert(element[(own + 1) % n]);
    joined.insert(element[(own + n - 1) % n]);
  }
  return joined;
}

}  // namespace

Vector3d position_of(const Location& where, const Deck& deck) {
  if (where.at.size() != 3) return deck.grid(where.node).position;
  return {where.at[0], where.at[1], where.at[2]};
}

void add_shares(int grid,
                const CornerMotion& motion,
                std::vector<MotionShare>& shares) {
  for (int i = 0; i < 3; ++i) {
    if (motion.moved(i) != 0.0)
      shares.push_back({grid, i + 1, motion.moved(i)});
    if (motion.turned(i) != 0.0) {
      shares.push_back({grid, i + 4, motion.turned(i)});
    }
  }
}

std::vector<MotionShare> motion_between(const Deck& deck,
                                        const Location& where,
                                        int component) {
  const Vector3d at = position_of(where, deck);
  const Vector3d axis = Vector3d::Unit(component - 1);
  std::vector<MotionShare> shares;
  for (const Corners& grids : elements_at(deck, where.node)) {
    const std::vector<Vector3d> x = deck.positions(grids);
    const std::optional<Shapes> shapes = shapes_within(x, at);
    if (!shapes) continue;
    const std::vector<CornerMotion> corners = motion_along(x, *shapes, axis);
    for (std::size_t k = 0; k < grids.size(); ++k) {
      add_shares(grids[k], corners[k], shares);
    }
    return shares;
  }
  return shares;
}

std::vector<Location> moved_to(const Location& where,
                               const Vector3d& at,
                               const Deck& deck) {
  const int near = nearest_grid(deck, at);
  std::set<int> nodes = joined_to(deck, near);
  nodes.merge(joined_to(deck, where.node));
  nodes.insert({near, where.node});
  Location moved = where;
  moved.at = {at.x(), at.y(), at.z()};
  double least = 1e300;
  for (const int node : nodes) {
    Location tried = moved;
    tried.node = node;
    const double far = (deck.grid(node).position - at).norm();
    if (far >= least || motion_between(deck, tried, 1).empty()) continue;
    least = far;
    moved = tried;
  }
  if (least == 1e300) return {};
  return {moved};
}

double sides_apart(const Location& where, int grid, const Deck& deck) {
  const Vector3d from = deck.grid(where.node).position;
  double side = 0.0;
  for (const int other : joined_to(deck, where.node)) {
    if (other == grid) return 1.0;
    const double length = (deck.grid(other).position - from).norm();
    if (side == 0.0 || length < side) side = length;
  }
  if (side == 0.0) return 1.0;
  return std::max(1.0, (deck.grid(grid).position - from).norm() / side);
}

std::vector<Location> places_around(const Location& where,
                                    double step,
                                    const Deck& deck) {
  const Vector3d from = position_of(where, deck);
  const Vector3d node = deck.grid(where.node).position;
  std::vector<Location> places;
  for (const int other : joined_to(deck, where.node)) {
    const Vector3d at = from + step * (deck.grid(other).position - node);
    if (step >= 1.0) {
      // A surface need not go on straight so far.
      places.push_back(where);
      places.back().node = nearest_grid(deck, at);
      places.back().at.clear();
      continue;
    }
    const std::vector<Location> found = moved_to(where, at, deck);
    places.insert(places.end(), found.begin(), found.end());
  }
  return places;
}

}  // namespace tapfit::updating
