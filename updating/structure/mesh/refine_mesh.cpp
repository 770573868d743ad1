#include "updating/structure/mesh/refine_mesh.hpp"

#include "updating/structure/mesh/mesh_tying.hpp"
#include "updating/structure/mesh/split_edges.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

// Makes new elements out of those of a deck.
class Refiner {
 public:
  explicit Refiner(const Deck& deck) : edges_(deck) {
    for (const Rod& e : deck.rods) keep(e.id);
    for (const PointMass& e : deck.masses) keep(e.id);
    for (const ScalarElement& e : deck.scalars) keep(e.id);
    for (const Bush& e : deck.bushes) keep(e.id);
    for (const Solid& e : deck.solids) keep(e.id);
    for (const Shell& e : deck.shells) {
      if (!e.mids.empty() || deck.shell_properties.at(e.property).panel) {
        keep(e.id);
        edges_.mesh().deck.shells.push_back(e);
      } else {
        split(e);
      }
    }
    for (const Bar& e : deck.bars) split(e);
    tie_seams(edges_);
  }

  [[nodiscard]] RefinedDeck take() { return std::move(edges_.mesh()); }

 private:
  void keep(int id) { edges_.mesh().children[id] = {id}; }

  template <typename Element>
  void add_child(const Element& parent,
                 Element child,
                 std::vector<Element>& elements) {
    std::vector<int>& ids = edges_.mesh().children[parent.id];
    if (!ids.empty()) child.id = edges_.next_element();
    ids.push_back(child.id);
    elements.push_back(child);
  }

  void split(const Shell& shell) {
    const std::size_t n = shell.grids.size();
    std::vector<int> mids;
    for (std::size_t i = 0; i < n; ++i) {
      mids.push_back(edges_.middle(shell.grids[i], shell.grids[(i + 1) % n]));
    }
    const int centre = n == 4 ? edges_.add_grid(shell.grids) : 0;
    for (std::size_t i = 0; i < n; ++i) {
      Shell child = shell;
      const int before = mids[(i + n - 1) % n];
      if (n == 4) {
        child.grids = {shell.grids[i], mids[i], centre, before};
      } else {
        child.grids = {shell.grids[i], mids[i], before};
      }
      child.theta_deg = child_angle(shell, child);
      add_child(shell, child, edges_.mesh().deck.shells);
    }
    if (n == 4) return;
    Shell inner = shell;
    inner.grids = {mids[0], mids[1], mids[2]};
    inner.theta_deg = child_angle(shell, inner);
    add_child(shell, inner, edges_.mesh().deck.shells);
  }

  // The material axis stays where it is while side 1-2 of the child turns.
  double child_angle(const Shell& parent, const Shell& child) const {
    const auto at = [&](int id) { return edges_.grid_of(id).position; };
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
    const int mid = edges_.middle(bar.grids[0], bar.grids[1]);
    const Eigen::Vector3d offset = 0.5 * (bar.offsets[0] + bar.offsets[1]);
    Bar first = bar;
    first.grids[1] = mid;
    first.offsets[1] = offset;
    first.released[1].clear();
    Bar second = bar;
    second.grids[0] = mid;
    second.offsets[0] = offset;
    second.released[0].clear();
    add_child(bar, first, edges_.mesh().deck.bars);
    add_child(bar, second, edges_.mesh().deck.bars);
  }

  SplitEdges edges_;
};

}  // namespace

bool can_refine(const Deck& deck) {
  return deck.solids.empty() &&
         std::ranges::all_of(deck.shells,
                             [](const Shell& e) { return e.mids.empty(); });
}

RefinedDeck refine_mesh(const Deck& deck) { return Refiner(deck).take(); }

}  // namespace tapfit::structure
