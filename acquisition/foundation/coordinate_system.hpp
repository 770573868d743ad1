// Rectangular, cylindrical and spherical coordinate systems, of decks and of
// universal files.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace tapfit {

enum class CoordinateKind { Rectangular, Cylindrical, Spherical };

/// A coordinate system in basic axes. Coordinates of a cylindrical one are r,
/// theta [degree], z; of a spherical one r, theta (from z), phi [degree].
struct CoordinateSystem {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns x, y, z
  CoordinateKind kind = CoordinateKind::Rectangular;

  /// The place with these coordinates, in basic axes.
  [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector3d& coordinates) const;
  /// Directions in which the coordinates grow at a place, columns in basic
  /// axes. On the axis of a cylinder or sphere those of theta = 0.
  [[nodiscard]] Eigen::Matrix3d directions(const Eigen::Vector3d& place) const;
};

/// Right-handed axes by an axis and a point beside it: `along` is axis `first`
/// (0 x, 2 z), and the x-z plane holds `beside`, on the positive side of the
/// other one of the two; columns x, y, z.
/// @return empty where the two vectors are parallel or one is zero
[[nodiscard]] std::optional<Eigen::Matrix3d> axes_through(
    int first, const Eigen::Vector3d& along, const Eigen::Vector3d& beside);

}  // namespace tapfit
