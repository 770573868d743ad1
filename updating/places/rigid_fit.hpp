// Lays one set of points over another by a rotation and a translation.
//
//   min sum |R a_k + t - b_k|^2   over pairs k        (Kabsch, Umeyama)
//
// Without pairs each point goes to the nearest place of the mesh, again and
// again (iterative closest points), from all 24 ways in which the principal
// axes of both sets can meet.
// Sources: S. Umeyama, IEEE PAMI 13, 1991, p. 376; P. J. Besl, N. D. McKay,
// IEEE PAMI 14, 1992, p. 239.
#pragma once

#include "updating/places/point_on_mesh.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::updating {

struct RigidFit {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double rms = 0.0;         ///< distance that is left
  double scale = 1.0;       ///< by which the first set would fit best
  double scaled_rms = 0.0;  ///< what would be left then
  /// Whether the pairs say the rotation: not where they lie on a line.
  bool determined = true;

  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& x) const {
    return rotation * x + translation;
  }
};

/// Whether points leave the turn about a line open: one, two, or all on a line.
/// @param points 3 x n
[[nodiscard]] bool on_a_line(const Eigen::Matrix3Xd& points);

/// @param from, to 3 x n, n >= 1
[[nodiscard]] RigidFit fit_pairs(const Eigen::Matrix3Xd& from,
                                 const Eigen::Matrix3Xd& to);

struct BestFitOptions {
  /// Below this part of the mesh size points count as on the mesh.
  double on_mesh = 1e-3;
  /// Another way to lie is as good within this factor and this part of the mesh
  /// size: what a test's coordinates are off by.
  double as_good_factor = 1.5;
  double as_good_size = 0.02;
  int steps = 60;
};

/// No motion, where the points lie on the mesh as they are; else empty.
/// @param points 3 x n, n >= 1
[[nodiscard]] std::optional<RigidFit> as_they_are(
    const Eigen::Matrix3Xd& points,
    const MeshSurface& surface,
    const BestFitOptions& options = {});

/// Ways to lie on the mesh, the best first, with those that are as good.
/// @param points 3 x n, not on_a_line
[[nodiscard]] std::vector<RigidFit> fit_to_mesh(
    const Eigen::Matrix3Xd& points,
    const structure::Deck& deck,
    const MeshSurface& surface,
    const BestFitOptions& options = {});

}  // namespace tapfit::updating
