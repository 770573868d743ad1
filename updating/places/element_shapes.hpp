// Shape functions of bars, triangles and quadrilaterals by their corners, with
// rotations, so that a bent bar or plate is followed to the third order along
// its sides; and of the faces of solids, without.
// Sources: J. S. Przemieniecki, "Theory of Matrix Structural Analysis", 1968,
// ch. 5 (beam); A. Adini, R. W. Clough, 1961, and R. J. Melosh, 1963 (plate of
// four corners); G. P. Bazeley et al., 1965 (of three).
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::updating {

/// A point in an element: each corner's share of a motion along a tangent, and
/// of one across it by the corner's own and by its slopes along two directions.
struct Shapes {
  std::vector<double> linear;
  std::vector<double> cubic;
  /// The direction of a slope in space, with its length, and its shares.
  struct Slope {
    std::vector<Eigen::Vector3d> along;  ///< one per corner
    std::vector<double> share;
  };
  std::vector<Slope> slopes;
  std::vector<Eigen::Vector3d> gradient;  ///< of `linear`, along the element
  /// There, of unit length, right-handed in the corners' order; of a bar zero.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double off = 0.0;  ///< distance of the point [m]
};

/// What a corner adds to a motion: moved . u + turned . theta.
struct CornerMotion {
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
};

/// The motion along an axis where the shapes are, corner by corner.
[[nodiscard]] std::vector<CornerMotion> motion_along(
    const std::vector<Eigen::Vector3d>& x,
    const Shapes& shapes,
    const Eigen::Vector3d& axis);

/// Shares at the foot of a point.
/// @param x corners: two of a bar, three, four [m]
/// @return empty where the foot lies beyond the element's sides
[[nodiscard]] std::optional<Shapes> shapes_at(
    const std::vector<Eigen::Vector3d>& x, const Eigen::Vector3d& at);

/// The part of a direction that is across an element: of a bar all but its
/// own, of a shell along its normal.
[[nodiscard]] Eigen::Vector3d across(const std::vector<Eigen::Vector3d>& x,
                                     const Eigen::Vector3d& axis);

/// The normal of three or four corners, right-handed in their order.
[[nodiscard]] Eigen::Vector3d normal_of(const std::vector<Eigen::Vector3d>& x);

/// The place in an element that is nearest to a point: its foot, or on a side.
[[nodiscard]] Eigen::Vector3d nearest_in(const std::vector<Eigen::Vector3d>& x,
                                         const Eigen::Vector3d& at);

}  // namespace tapfit::updating
