// Points, lines and elements of a universal file.
//
//   15    4I10,3E13.5             node, axes, axes, colour, x y z
//   2411  4I10 / 3D25.16          the same on two lines
//   82    3I10 / 80A1 / 8I10      trace line: number, how many, 0 lifts the pen
//   2412  6I10 (/ 3I10) / 8I10    element; beams have an orientation line
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include "acquisition/foundation/coordinate_system.hpp"
#include "acquisition/uff/uff_datasets.hpp"

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace tapfit::acquisition {

struct UffElement {
  int label = 0;
  int kind =
      0;  ///< FE descriptor: 21 beam, 41/91 triangle, 44/94 quadrilateral
  std::vector<int> nodes;
};

/// A coordinate system by three points, see uff_systems.hpp.
struct UffSystem {
  CoordinateKind kind = CoordinateKind::Rectangular;
  int reference = 0;  ///< system that the points count in
  /// Columns: the origin, a point on +x, one on the +xz plane.
  Eigen::Matrix3d points = Eigen::Matrix3d::Identity();
  std::string place;  ///< dataset and line, for messages
};

/// Systems that a node's coordinates and its directions count in.
struct UffNodeSystems {
  int definition = 0;
  int displacement = 0;
  std::string place;  ///< of the dataset
};

/// In the file's own units and axes.
struct UffGeometry {
  std::map<int, Eigen::Vector3d> nodes;  ///< in their definition systems
  /// Of nodes that have others than 0 and 0.
  std::map<int, UffNodeSystems> node_systems;
  std::map<int, UffSystem> systems;
  std::vector<std::vector<int>> trace_lines;  ///< nodes; pieces apart
  std::vector<UffElement> elements;
};

/// Adds what a dataset 15, 2411, 82 or 2412 holds; another one adds nothing.
///
/// @throws InputError with the line for text that is no number and for a
///   dataset that ends within an entry
void add_geometry(const UffDataset& dataset, UffGeometry& geometry);

}  // namespace tapfit::acquisition
