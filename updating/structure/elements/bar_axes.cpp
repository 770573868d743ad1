#include "updating/structure/elements/bar_axes.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tapfit::structure {

BarAxes bar_axes(const Deck& deck, const Bar& bar) {
  const Eigen::Vector3d a = deck.grid(bar.grids[0]).position + bar.offsets[0];
  const Eigen::Vector3d b = deck.grid(bar.grids[1]).position + bar.offsets[1];
  BarAxes axes;
  axes.length = (b - a).norm();
  const Eigen::Vector3d x = (b - a).normalized();
  const Eigen::Vector3d z = x.cross(bar.orientation);
  if (!(axes.length > 0.0) || !(z.norm() > 1e-8 * bar.orientation.norm())) {
    throw InputError(
        "the bar has no length, or its orientation vector lies along it",
        card_place(deck, bar.where, fmt::format("bar {}", bar.id)),
        "Correct the grids, offsets or orientation.");
  }
  axes.local << x, z.normalized().cross(x), z.normalized();
  return axes;
}

}  // namespace tapfit::structure
