// Lowest and highest value of many samples in one pass.
#pragma once

#include <Eigen/Core>

#include <limits>

namespace tapfit::acquisition {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// @param x finite values; none give an empty range, low above high
[[nodiscard]] Range range_of(const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace tapfit::acquisition
