// Points of the test's own: where a sensor or a blow sits that is no grid of
// the model in a basic direction. Each has three axes, so that a sensor of
// three axes is one point.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// A Dof with node -label is along one of its axes.
struct TestPoint {
  int label = 0;
  int node = 0;     ///< the grid that it is at; 0: at coordinates
  int of_node = 0;  ///< the node of the test's geometry that it is at; or 0
  /// Coordinates [m] where they are said: in the model's basic axes, or in the
  /// test's own where it is at a node of the test's geometry. At a grid the
  /// model's count.
  std::optional<Eigen::Vector3d> at;
  /// Of the sensing element above the surface, along its normal [m].
  double height_m = 0.0;
  /// Directions of its components X, Y, Z, columns in the axes that its
  /// coordinates count in; in those of `system` there, where that is not 0.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  int system = 0;     ///< a coordinate system of the model
  std::string place;  ///< what says so, "test.json: runs[0].hammer.point"
};

/// Whether only a model says where the point is, or what its axes are.
[[nodiscard]] bool needs_model(const TestPoint& point);

/// The point of a label; nothing where there is none.
[[nodiscard]] const TestPoint* find_point(const std::vector<TestPoint>& points,
                                          int label);

}  // namespace tapfit::acquisition
