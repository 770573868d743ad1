// The grids that come between those of a deck when its elements are split: one
// per edge, whoever asks first, held and rigid as the ends of the edge are.
#pragma once

#include "updating/structure/mesh/refined_deck.hpp"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace tapfit::structure {

/// Digits of 1..6, in any order.
using Components = std::string;

/// What a grid at the same place as another follows, and in which components.
struct Double {
  int leader = 0;
  Components components;
};

/// An edge that was split, and both of whose ends are held.
struct HeldEdge {
  std::array<int, 2> ends{};
  int middle = 0;
};

class SplitEdges {
 public:
  /// Starts from all of the deck but its shells and bars, which are to be added
  /// in parts, and its cards.
  explicit SplitEdges(const Deck& deck);

  [[nodiscard]] RefinedDeck& mesh() { return mesh_; }
  [[nodiscard]] const Grid& grid_of(int id) const;
  /// Of an element that is still to be made.
  [[nodiscard]] int next_element() { return next_element_++; }

  /// A new grid in the middle of several.
  int add_grid(const std::vector<int>& between);
  /// The grid in the middle of an edge, new where it has none yet. It is held
  /// where both ends are.
  int middle(int a, int b);

  /// What all of several grids have, said along a new grid's axes: nothing but
  /// whole triples where axes differ.
  ///
  /// @param of components of each of them
  [[nodiscard]] Components shared(
      const Grid& grid,
      const std::vector<int>& between,
      const std::function<Components(int)>& of) const;

  /// Of all edges that were split: the middle, by the ends in ascending order.
  [[nodiscard]] const std::map<std::array<int, 2>, int>& middles() const {
    return middles_;
  }
  [[nodiscard]] const std::vector<HeldEdge>& held_edges() const {
    return held_edges_;
  }
  /// Grids that rigid elements of no length tie to others, by their id.
  [[nodiscard]] const std::unordered_map<int, Double>& doubles() const {
    return doubles_;
  }

 private:
  void see_rigid(std::size_t k, double extent);
  void follow(const Grid& grid, const std::vector<int>& between);

  RefinedDeck mesh_;
  int next_grid_ = 1;
  int next_element_ = 1;
  std::map<std::array<int, 2>, int> middles_;
  std::vector<HeldEdge> held_edges_;
  std::map<int, Components> held_;
  // Per grid: the rigid elements that it belongs to, and in which components.
  std::unordered_map<int, std::map<std::size_t, Components>> rigid_;
  std::unordered_map<int, Double> doubles_;
};

}  // namespace tapfit::structure
