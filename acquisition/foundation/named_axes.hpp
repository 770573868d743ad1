// Axes of a measuring point, named after the basic axes that they are closest
// to: what is called Z points mostly along Z.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace tapfit {

/// What three digits of each component leave open, in rad: of a direction up to
/// 0.9e-3, of a right angle twice that, of the axis across two 2.1e-3.
inline constexpr double as_written = 2.5e-3;

/// Right-handed axes with a direction among them, as the component that it is
/// closest to: what is called Z points mostly along Z.
struct NamedDirection {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  int component = 3;  ///< 1..3
  int sign = 1;
};

/// @param direction of unit length
[[nodiscard]] NamedDirection axes_along(const Eigen::Vector3d& direction);

/// The component and sign by which axes say a direction; empty where none of
/// them is along it as_written.
/// @param direction of unit length
[[nodiscard]] std::optional<NamedDirection> along_one_of(
    const Eigen::Matrix3d& axes, const Eigen::Vector3d& direction);

/// The same three axes in other order and sense, so that each is the component
/// of the basic axis that it is closest to.
[[nodiscard]] Eigen::Matrix3d named_like_basic(const Eigen::Matrix3d& axes);

}  // namespace tapfit
