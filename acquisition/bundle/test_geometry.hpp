// The test's own mesh: points with numbers and axes that are not the model's.
// Where it lies on the model is found when that is read, from pairs of a point
// and a grid, or by best fit.
#pragma once

#include "acquisition/bundle/test_point.hpp"
#include "acquisition/foundation/dof.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <vector>

namespace tapfit::acquisition {

/// A point of the test and where it is on the model.
struct NamedPair {
  int label = 0;
  int grid = 0;  ///< of the model; 0: at coordinates
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< basic axes [m]
};

struct TestGeometry {
  std::filesystem::path file;
  std::map<int, Eigen::Vector3d> nodes;  ///< by label, in the test's axes [m]
  /// What X, Y, Z mean at nodes that have axes of their own, columns in the
  /// test's axes.
  std::map<int, Eigen::Matrix3d> directions;
  std::vector<NamedPair> pairs;  ///< none: by best fit
};

/// A node's degree of freedom at the point of the test's own that it is: that
/// point's axes are named_like_basic() those of the node.
[[nodiscard]] Dof at_own_point(const TestGeometry& geometry, const Dof& dof);

/// The point that a node is.
[[nodiscard]] TestPoint own_point(const TestGeometry& geometry, int label);

}  // namespace tapfit::acquisition
