// A structure's lines, and what is shown on them.
#pragma once

#include "tui/screen/screen.hpp"
#include "tui/widgets/mesh_lines.hpp"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

struct Wireframe {
  Eigen::Matrix3Xd points;  ///< per deck grid [m]
  std::vector<Edge> lines;  ///< indices into points
  std::vector<MeshEdge>
      ranks;                 ///< per line: which of them a coarser picture has
  std::map<int, int> index;  ///< grid id to index
  /// Axes of the test's own points, columns: displacements there count along
  /// them.
  std::map<int, Eigen::Matrix3d> axes;
};

struct Mark {
  int node = 0;
  char32_t glyph = U'●';
  Style style;
  std::string label;  ///< written beside it where there is room
  /// What it stands for, for tables.
  std::optional<double> value = {};
};

struct Scene {
  std::vector<Mark> marks;       ///< nodes that are not there are left out
  std::string value_name;        ///< of the marks, with its unit
  std::vector<int> highlighted;  ///< nodes whose lines are drawn in orange
  Eigen::Matrix3Xd shape;        ///< displacement per point, or empty
  std::map<int, Eigen::Vector3d> stems;  ///< displacement of single nodes
  double phase = 1.0;  ///< factor on the displacements, -1 .. 1
};

}  // namespace tapfit::tui
