// The axes of a bar in which its section is told.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

namespace tapfit::structure {

struct BarAxes {
  double length = 0.0;    ///< between the ends, offsets included [m]
  Eigen::Matrix3d local;  ///< columns: axis, plane 1, plane 2
};

/// @throws InputError for a bar without length, or with its orientation vector
///   along it
[[nodiscard]] BarAxes bar_axes(const Deck& deck, const Bar& bar);

}  // namespace tapfit::structure
