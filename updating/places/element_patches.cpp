#include "updating/places/element_patches.hpp"

#include "updating/places/bars_in_line.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// A box counts as another one when it holds an eighth more elements: less
// than that no measurement tells.
constexpr double growth = 1.125;
// Beyond this a loss is not local.
constexpr std::size_t largest_patch = 100;
// Of bars in line: beyond it one more is less than `growth`.
constexpr std::size_t longest_run = 8;
// Around an edge; larger boxes are nearly those around its ends.
constexpr std::size_t largest_at_edge = 12;

struct Middle {
  int id = 0;
  int property = 0;
  Vector3d position;
};

template <typename Elements>
void add_middles(const Deck& deck,
                 const Elements& elements,
                 std::vector<Middle>& middles) {
  for (const auto& e : elements) {
    Middle middle{e.id, e.property, Vector3d::Zero()};
    for (const int grid : e.grids) {
      middle.position += deck.grids[deck.grid_index(grid)].position;
    }
    middle.position /= static_cast<double>(e.grids.size());
    middles.push_back(middle);
  }
}

// Of the shells.
std::vector<Vector3d> edge_middles(const Deck& deck) {
  std::set<std::pair<int, int>> edges;
  for (const structure::Shell& e : deck.shells) {
    for (std::size_t k = 0; k < e.grids.size(); ++k) {
      edges.insert(
          std::minmax({e.grids[k], e.grids[(k + 1) % e.grids.size()]}));
    }
  }
  std::vector<Vector3d> middles;
  for (const auto& [a, b] : edges) {
    middles.emplace_back(0.5 * (deck.grids[deck.grid_index(a)].position +
                                deck.grids[deck.grid_index(b)].position));
  }
  return middles;
}

class Patches {
 public:
  explicit Patches(const Deck& deck) {
    add_middles(deck, deck.shells, middles_);
    add_middles(deck, deck.bars, middles_);
    add_middles(deck, deck.rods, middles_);
    add_middles(deck, deck.solids, middles_);
    const std::size_t limit = std::min(largest_patch, middles_.size() / 4);
    for (const Middle& middle : middles_) take({middle.id});
    for (const Middle& middle : middles_) boxes_around(middle.position, limit);
    for (const structure::Grid& grid : deck.grids) {
      if (grid.id < 0) continue;
      boxes_around(grid.position, limit);
    }
    for (const Vector3d& edge : edge_middles(deck)) {
      boxes_around(edge, std::min(limit, largest_at_edge));
    }
    for (std::vector<int>& run :
         bars_in_line(deck, std::min(limit, longest_run))) {
      take(std::move(run));
    }
    std::map<int, std::vector<int>> of_property;
    for (const Middle& e : middles_) of_property[e.property].push_back(e.id);
    for (auto& [property, ids] : of_property) {
      if (2 * ids.size() <= middles_.size()) take(std::move(ids));
    }
  }

  [[nodiscard]] std::vector<std::vector<int>> result() && {
    return std::move(result_);
  }

 private:
  void take(std::vector<int> ids) {
    std::sort(ids.begin(), ids.end());
    if (seen_.insert(ids).second) result_.push_back(std::move(ids));
  }

  void boxes_around(const Vector3d& at, std::size_t limit) {
    std::vector<std::pair<double, int>> order;
    for (const Middle& e : middles_) {
      order.emplace_back((e.position - at).cwiseAbs().maxCoeff(), e.id);
    }
    const std::size_t count = std::min(order.size(), limit + 1);
    std::partial_sort(order.begin(),
                      order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end());
    std::vector<int> ids;
    std::size_t last = 0;
    for (std::size_t k = 0; k < count; ++k) {
      ids.push_back(order[k].second);
      // Elements at one distance come together.
      const bool full =
          k + 1 == count ||
          order[k + 1].first > order[k].first * (1.0 + 1e-6) + 1e-12;
      const auto size = static_cast<double>(ids.size());
      if (!full || ids.size() > limit) continue;
      if (size < growth * static_cast<double>(last)) continue;
      last = ids.size();
      take(ids);
    }
  }

  std::vector<Middle> middles_;
  std::set<std::vector<int>> seen_;
  std::vector<std::vector<int>> result_;
};

}  // namespace

std::vector<std::vector<int>> element_patches(const Deck& deck) {
  return Patches(deck).result();
}

}  // namespace tapfit::updating
