#include "acquisition/foundation/named_axes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// The turn that takes the closest basic axis there the shortest way, so that
// the other two stay as close to theirs as they can.
NamedDirection axes_along(const Vector3d& direction) {
  NamedDirection named;
  Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  named.component = static_cast<int>(axis) + 1;
  named.sign = direction(axis) < 0.0 ? -1 : 1;
  const Vector3d along = named.sign * direction;
  named.axes = Eigen::Quaterniond::FromTwoVectors(Vector3d::Unit(axis), along)
                   .toRotationMatrix();
  named.axes.col(axis) = along;
  return named;
}

std::optional<NamedDirection> along_one_of(const Matrix3d& axes,
                                           const Vector3d& direction) {
  for (Index axis = 0; axis < 3; ++axis) {
    for (const int sign : {1, -1}) {
      if ((sign * axes.col(axis) - direction).norm() > as_written) continue;
      return NamedDirection{axes, static_cast<int>(axis) + 1, sign};
    }
  }
  return std::nullopt;
}

Matrix3d named_like_basic(const Matrix3d& axes) {
  std::array<Index, 3> order{0, 1, 2};
  std::array<Index, 3> best = order;
  double most = -1.0;
  do {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += std::abs(axes(static_cast<Index>(i), order[i]));
    }
    if (sum > most + 1e-9) {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  Matrix3d named;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Index>(i);
    const Vector3d axis = axes.col(best[i]);
    named.col(row) = axis(row) < 0.0 ? Vector3d(-axis) : axis;
  }
  return named;
}

}  // namespace tapfit
