// Where on the mesh a point is, and how it moves: the nearest place of the
// nearest element, followed by its shape functions, and from there a rigid arm.
//
//   u(p) . d = u(f) . d + theta(f) . (r x d),   r = p - f
//
// On shells and bars theta is that of the grids (sum N_k theta_k). On the face
// of a solid, whose grids do not turn, and on rods it is what the motion of the
// face says, with n its normal and t the rod's axis:
//
//   theta = sum_k (grad N_k x n) (n . u_k) + n (n x grad N_k) . u_k / 2
//   theta = sum_k (grad N_k . t) t x u_k
//
// Elements with grids in the middle of sides follow them by their quadratic
// functions.
#pragma once

#include "updating/places/between_grids.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// An element, or a solid's outer face; one grid alone.
struct MeshPart {
  enum class Kind { Grid, Shell, Face, Bar, Rod };
  Kind kind = Kind::Grid;
  int element = 0;         ///< id; of the grid where it is one
  std::vector<int> grids;  ///< corners
  std::vector<int> mids;   ///< per side, from the first on; 0: none
};

/// A point and the part of the mesh that carries it.
struct PointOnMesh {
  MeshPart part;
  Eigen::Vector3d foot;  ///< nearest place of the part [m]
  double off = 0.0;      ///< distance from there [m]
  double size = 0.0;     ///< mean length of the part's sides [m]
  /// The foot on sides that are straight: of a grid in the middle of a curved
  /// one halfway between the corners.
  Eigen::Vector3d straight_foot = Eigen::Vector3d::Zero();
  /// Mean of the normals of shells and faces there, of unit length; zero where
  /// there is none or where the surface folds.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

class MeshSurface {
 public:
  /// @param deck outlives this object
  explicit MeshSurface(const structure::Deck& deck);

  /// @param at basic axes [m]
  /// @return empty for a deck without elements and grids
  [[nodiscard]] std::optional<PointOnMesh> nearest(
      const Eigen::Vector3d& at) const;

  /// A grid, on an element that it is a corner of where there is one.
  [[nodiscard]] PointOnMesh at_grid(int grid) const;

 private:
  [[nodiscard]] Eigen::Vector3d normal_at(const Eigen::Vector3d& foot,
                                          double tolerance,
                                          int grid) const;

  struct Placed {
    MeshPart part;
    std::vector<Eigen::Vector3d> x;  // corners
    Eigen::Vector3d middle;
    double reach = 0.0;  // of the corners from there
  };

  const structure::Deck* deck_;
  std::vector<Placed> parts_;
};

/// The motion of a point along a direction, basic axes.
/// @param at of the point, wherever it is [m]
[[nodiscard]] std::vector<MotionShare> motion_at(const PointOnMesh& point,
                                                 const structure::Deck& deck,
                                                 const Eigen::Vector3d& at,
                                                 const Eigen::Vector3d& axis);

/// How it turns about a direction.
[[nodiscard]] std::vector<MotionShare> turning_at(const PointOnMesh& point,
                                                  const structure::Deck& deck,
                                                  const Eigen::Vector3d& axis);

/// "shell 12", "grid 7".
[[nodiscard]] std::string describe(const MeshPart& part);

}  // namespace tapfit::updating
