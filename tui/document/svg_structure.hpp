// The structure's mesh, its points and its shapes as an SVG picture, seen from
// above and aside.
#pragma once

#include "tui/widgets/wireframe.hpp"

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace tapfit::tui {

struct SvgMark {
  int node = 0;  ///< those that are not there are left out
  std::string label;
  std::string colour;
  double radius = 4.0;
};

struct SvgStructure {
  std::string name;  ///< what it shows
  std::vector<SvgMark> marks;
  double width = 680.0;
  double tallest = 420.0;  ///< the height is the structure's, at most this
};

/// The structure at rest, and the basic axes in a corner.
[[nodiscard]] std::string svg_structure(const Wireframe& wire,
                                        const SvgStructure& picture);

/// A shape that swings; without animation it stands at its largest.
struct SvgShape {
  std::string name;
  Eigen::Matrix3Xd grids;  ///< displacement per point of the wire; or empty
  std::map<int, Eigen::Vector3d> points;  ///< measured, of single nodes
  double width = 340.0;
  double tallest = 260.0;
};

/// Grey at rest, the grids' shape in blue, measured points as dots in orange.
/// The largest displacement is drawn as an eighth of the structure's size.
[[nodiscard]] std::string svg_shape(const Wireframe& wire,
                                    const SvgShape& shape);

}  // namespace tapfit::tui
