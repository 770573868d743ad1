#include "updating/places/element_patches.hpp"

#include "updating/places/bars_in_line.hpp"
#include "updating/places/element_cells.hpp"
#include "updating/places/gathered.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// A box counts as another one when it holds an eighth more cells: less
// than that no measurement tells.
constexpr double growth = 1.125;
// Of cells; beyond this a loss is not local.
constexpr std::size_t largest_patch = 100;
// Of bars in line: beyond it one more is less than `growth`.
constexpr std::size_t longest_run = 8;
// Around an edge; larger boxes are nearly those around its ends.
constexpr std::size_t largest_at_edge = 12;

std::vector<Vector3d> positions_of_grids(const Deck& deck) {
  std::vector<Vector3d> grids;
  for (const structure::Grid& grid : deck.grids) {
    if (grid.id >= 0) grids.push_back(grid.position);
  }
  return grids;
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
    middles.emplace_back(0.5 * (deck.grid(a).position + deck.grid(b).position));
  }
  return middles;
}

class Patches {
 public:
  explicit Patches(const Deck& deck) : cells_(element_cells(deck)) {
    const std::size_t limit = std::min(largest_patch, cells_.size() / 4);
    for (const ElementCell& cell : cells_) take(cell.elements);
    for (const ElementCell& cell : cells_) boxes_around(cell.middle, limit);
    boxes_around_each(positions_of_grids(deck), limit);
    boxes_around_each(edge_middles(deck), std::min(limit, largest_at_edge));
    for (std::vector<int>& run :
         bars_in_line(deck, std::min(limit, longest_run))) {
      take(std::move(run));
    }
    std::map<int, std::vector<int>> of_property;
    for (const ElementCell& cell : cells_) {
      std::vector<int>& own = of_property[cell.property];
      own.insert(own.end(), cell.elements.begin(), cell.elements.end());
    }
    const std::size_t all = deck.shells.size() + deck.bars.size() +
                            deck.rods.size() + deck.solids.size();
    for (auto& [property, ids] : of_property) {
      if (2 * ids.size() <= all) take(std::move(ids));
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

  void boxes_around_each(const std::vector<Vector3d>& all, std::size_t limit) {
    for (const std::size_t k : spread_out(all)) boxes_around(all[k], limit);
  }

  void boxes_around(const Vector3d& at, std::size_t limit) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      order.emplace_back((cells_[k].middle - at).cwiseAbs().maxCoeff(), k);
    }
    const std::size_t count = std::min(order.size(), limit + 1);
    std::partial_sort(order.begin(),
                      order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end());
    std::vector<int> ids;
    std::size_t last = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::vector<int>& own = cells_[order[k].second].elements;
      ids.insert(ids.end(), own.begin(), own.end());
      // Cells at one distance come together.
      const bool full =
          k + 1 == count ||
          order[k + 1].first > order[k].first * (1.0 + 1e-6) + 1e-12;
      const auto size = static_cast<double>(k + 1);
      if (!full || k + 1 > limit) continue;
      if (size < growth * static_cast<double>(last)) continue;
      last = k + 1;
      take(ids);
    }
  }

  std::vector<ElementCell> cells_;
  std::set<std::vector<int>> seen_;
  std::vector<std::vector<int>> result_;
};

}  // namespace

std::vector<std::vector<int>> element_patches(const Deck& deck) {
  return Patches(deck).result();
}

}  // namespace tapfit::updating
