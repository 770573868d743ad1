#include "updating/structure/refine_mesh.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace tapfit::structure {
namespace {

std::string shared_components(const std::string& a, const std::string& b) {
  std::string both;
  for (const char digit : a) {
    if (b.find(digit) != std::string::npos) both += digit;
  }
  return both;
}

// Makes new grids and elements, one grid per edge whoever asks first.
class Refiner {
 public:
  explicit Refiner(const Deck& deck) {
    result_.deck = deck;
    Deck& out = result_.deck;
    out.shells.clear();
    out.bars.clear();
    out.cards.clear();
    for (const Grid& grid : deck.grids) {
      next_grid_ = std::max(next_grid_, grid.id + 1);
    }
    for (const Constraint& held : deck.constraints) {
      held_[held.grid] += held.components;
    }
    for (const Shell& e : deck.shells) see_element(e.id);
    for (const Bar& e : deck.bars) see_element(e.id);
    for (const Rod& e : deck.rods) keep(e.id);
    for (const PointMass& e : deck.masses) keep(e.id);
    for (const ScalarElement& e : deck.scalars) keep(e.id);
    for (const Bush& e : deck.bushes) keep(e.id);
    for (const Shell& e : deck.shells) split(e);
    for (const Bar& e : deck.bars) split(e);
  }

  [[nodiscard]] RefinedDeck take() { return std::move(result_); }

 private:
  void see_element(int id) { next_element_ = std::max(next_element_, id + 1); }

  void keep(int id) {
    see_element(id);
    result_.children[id] = {id};
  }

  int add_grid(const std::vector<int>& between) {
    Grid grid;
    grid.id = next_grid_++;
    grid.position.setZero();
    for (const int id : between) {
      grid.position += result_.deck.grids[result_.deck.grid_index(id)].position;
    }
    grid.position /= static_cast<double>(between.size());
    result_.deck.grids.push_back(grid);
    result_.between[grid.id] = between;
    return grid.id;
  }

  int middle(int a, int b) {
    const auto [place, is_new] =
        middles_.try_emplace({std::min(a, b), std::max(a, b)}, 0);
    if (!is_new) return place->second;
    const int id = add_grid({a, b});
    place->second = id;
    const std::string both = shared_components(held_[a], held_[b]);
    if (!both.empty()) result_.deck.constraints.push_back({id, both});
    return id;
  }

  template <typename Element>
  void add_child(const Element& parent,
                 Element child,
                 std::vector<Element>& elements) {
    std::vector<int>& ids = result_.children[parent.id];
    if (!ids.empty()) child.id = next_element_++;
    ids.push_back(child.id);
    elements.push_back(child);
  }

  void split(const Shell& shell) {
    const std::size_t n = shell.grids.size();
    std::vector<int> mids;
    for (std::size_t i = 0; i < n; ++i) {
      mids.push_back(middle(shell.grids[i], shell.grids[(i + 1) % n]));
    }
    const int centre = n == 4 ? add_grid(shell.grids) : 0;
    for (std::size_t i = 0; i < n; ++i) {
      Shell child = shell;
      const int before = mids[(i + n - 1) % n];
      if (n == 4) {
        child.grids = {shell.grids[i], mids[i], centre, before};
      } else {
        child.grids = {shell.grids[i], mids[i], before};
      }
      child.theta_deg = child_angle(shell, child);
      add_child(shell, child, result_.deck.shells);
    }
    if (n == 4) return;
    Shell inner = shell;
    inner.grids = {mids[0], mids[1], mids[2]};
    inner.theta_deg = child_angle(shell, inner);
    add_child(shell, inner, result_.deck.shells);
  }

  // The material axis stays where it is while side 1-2 of the child turns.
  double child_angle(const Shell& parent, const Shell& child) const {
    const auto at = [&](int id) {
      return result_.deck.grids[result_.deck.grid_index(id)].position;
    };
    const Eigen::Vector3d side = at(parent.grids[1]) - at(parent.grids[0]);
    const Eigen::Vector3d normal =
        side.cross(at(parent.grids.back()) - at(parent.grids[0]))
            .stableNormalized();
    const Eigen::Vector3d turned = at(child.grids[1]) - at(child.grids[0]);
    const double angle =
        std::atan2(normal.dot(side.cross(turned)), side.dot(turned));
    return parent.theta_deg - angle * 180.0 / std::numbers::pi;
  }

  void split(const Bar& bar) {
    const int mid = middle(bar.grids[0], bar.grids[1]);
    const Eigen::Vector3d offset = 0.5 * (bar.offsets[0] + bar.offsets[1]);
    Bar first = bar;
    first.grids[1] = mid;
    first.offsets[1] = offset;
    first.released[1].clear();
    Bar second = bar;
    second.grids[0] = mid;
    second.offsets[0] = offset;
    second.released[0].clear();
    add_child(bar, first, result_.deck.bars);
    add_child(bar, second, result_.deck.bars);
  }

  RefinedDeck result_;
  int next_grid_ = 1;
  int next_element_ = 1;
  std::map<std::array<int, 2>, int> middles_;
  std::unordered_map<int, std::string> held_;
};

}  // namespace

RefinedDeck refine_mesh(const Deck& deck) { return Refiner(deck).take(); }

}  // namespace tapfit::structure
