#include "updating/places/stretched_patches.hpp"

#include "updating/places/element_cells.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using structure::Deck;

/// A cell of elements as a box along the axes.
struct Block {
  std::vector<int> elements;
  Vector3d middle = Vector3d::Zero();
  Vector3d half = Vector3d::Zero();  ///< of its lengths
};

// Rows are the axes.
Eigen::Matrix3d axes_of(const std::vector<Vector3d>& at) {
  const Vector3d first = (at[1] - at[0]).normalized();
  Vector3d normal = at.size() > 2 ? Vector3d(first.cross(at[2] - at[0]))
                                  : Vector3d(first.unitOrthogonal());
  normal.normalize();
  Eigen::Matrix3d axes;
  axes << first.transpose(), normal.cross(first).transpose(),
      normal.transpose();
  return axes;
}

template <class Visit>
void for_each_element(const Deck& deck, Visit visit) {
  for (const auto& e : deck.shells) visit(e.id, deck.positions(e.grids));
  for (const auto& e : deck.bars) visit(e.id, deck.positions(e.grids));
  for (const auto& e : deck.rods) visit(e.id, deck.positions(e.grids));
  for (const auto& e : deck.solids) visit(e.id, deck.positions(e.grids));
}

std::vector<Block> blocks_of(const Deck& deck, int first) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  for_each_element(deck, [&](int id, const std::vector<Vector3d>& at) {
    if (id == first) axes = axes_of(at);
  });
  std::map<int, std::vector<Vector3d>> turned;  // corners, by element
  for_each_element(deck, [&](int id, const std::vector<Vector3d>& at) {
    for (const Vector3d& corner : at) turned[id].push_back(axes * corner);
  });
  std::vector<Block> blocks;
  for (ElementCell& cell : element_cells(deck)) {
    Block block{std::move(cell.elements), axes * cell.middle, {}};
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::max());
    Vector3d high = -low;
    for (const int id : block.elements) {
      for (const Vector3d& corner : turned.at(id)) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
      }
    }
    block.half = 0.5 * (high - low);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

/// The patch among all cells.
class Stretch {
 public:
  Stretch(const std::vector<int>& patch, const Deck& deck)
      : blocks_(blocks_of(deck, patch.front())) {
    for (const Block& block : blocks_) {
      const bool in = std::ranges::binary_search(patch, block.elements.front());
      (in ? inside_ : outside_).push_back(&block);
    }
    for (const Block* block : inside_) {
      low_ = low_.cwiseMin(block->middle - block->half);
      high_ = high_.cwiseMax(block->middle + block->half);
    }
  }

  // Without the layer that lies farthest along an axis; `sign` -1 turns it.
  [[nodiscard]] std::vector<int> shorter(Index axis, double sign) const {
    const auto along = [&](const Block* b) { return sign * b->middle[axis]; };
    const Block* last = *std::ranges::max_element(inside_, {}, along);
    const double end = along(last) - layer(*last, axis);
    std::vector<int> ids;
    for (const Block* b : inside_) {
      if (along(b) < end) take(*b, ids);
    }
    std::ranges::sort(ids);
    return ids;
  }

  // The next layer of those that lie beside the patch.
  [[nodiscard]] std::vector<int> next_layer(Index axis, double sign) const {
    const auto along = [&](const Block* b) { return sign * b->middle[axis]; };
    const double begin = sign > 0.0 ? high_[axis] : -low_[axis];
    std::vector<const Block*> ahead;
    for (const Block* b : outside_) {
      if (along(b) > begin && beside(*b, axis)) ahead.push_back(b);
    }
    if (ahead.empty()) return {};
    const Block* next = *std::ranges::min_element(ahead, {}, along);
    const double end = along(next) + layer(*next, axis);
    std::vector<int> ids;
    for (const Block* b : ahead) {
      if (along(b) < end) take(*b, ids);
    }
    std::ranges::sort(ids);
    return ids;
  }

 private:
  static void take(const Block& block, std::vector<int>& ids) {
    ids.insert(ids.end(), block.elements.begin(), block.elements.end());
  }

  // Half of a cell; of one that is thin along the axis, a little.
  [[nodiscard]] static double layer(const Block& block, Index axis) {
    return std::max(block.half[axis], 1e-6 * block.half.maxCoeff());
  }

  // Whether the middle lies within the patch across an axis.
  [[nodiscard]] bool beside(const Block& block, Index axis) const {
    const double close = 1e-6 * block.half.maxCoeff();
    for (Index k = 0; k < 3; ++k) {
      if (k == axis) continue;
      if (block.middle[k] < low_[k] - close) return false;
      if (block.middle[k] > high_[k] + close) return false;
    }
    return true;
  }

  std::vector<Block> blocks_;
  std::vector<const Block*> inside_;
  std::vector<const Block*> outside_;
  Vector3d low_ = Vector3d::Constant(std::numeric_limits<double>::max());
  Vector3d high_ = -low_;
};

std::vector<int> joined(std::vector<int> patch, const std::vector<int>& layer) {
  patch.insert(patch.end(), layer.begin(), layer.end());
  std::ranges::sort(patch);
  return patch;
}

constexpr std::array<double, 2> signs = {1.0, -1.0};

}  // namespace

std::vector<std::vector<int>> stretched_patches(const std::vector<int>& patch,
                                                const Deck& deck) {
  const Stretch stretch(patch, deck);
  const std::size_t all = deck.shells.size() + deck.bars.size() +
                          deck.rods.size() + deck.solids.size();
  std::vector<std::vector<int>> result;
  for (Index axis = 0; axis < 3; ++axis) {
    for (const double sign : signs) {
      for (const std::vector<int>& ids :
           {stretch.shorter(axis, sign),
            joined(patch, stretch.next_layer(axis, sign))}) {
        const bool changed = !ids.empty() && ids.size() != patch.size();
        if (changed && 2 * ids.size() <= all) result.push_back(ids);
      }
    }
  }
  return result;
}

std::vector<int> inner_patch(std::vector<int> patch, const Deck& deck) {
  const Stretch whole(patch, deck);
  for (Index axis = 0; axis < 3; ++axis) {
    for (const double sign : signs) {
      if (whole.next_layer(axis, sign).empty()) continue;
      std::vector<int> less = Stretch(patch, deck).shorter(axis, sign);
      if (!less.empty()) patch = std::move(less);
    }
  }
  return patch;
}

std::vector<std::vector<int>> layers_beside(const std::vector<int>& patch,
                                            const Deck& deck) {
  const Stretch stretch(patch, deck);
  std::vector<std::vector<int>> result;
  for (Index axis = 0; axis < 3; ++axis) {
    for (const double sign : signs) {
      std::vector<int> layer = stretch.next_layer(axis, sign);
      if (!layer.empty()) result.push_back(std::move(layer));
    }
  }
  return result;
}

}  // namespace tapfit::updating
