// Curves in a plane with the same scale both ways: circles stay circles.
#pragma once

#include "tui/screen/dots.hpp"
#include "tui/screen/screen.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::tui {

/// Points in their order; joined, or single dots.
struct Path {
  std::string label;
  Eigen::VectorXd x;
  Eigen::VectorXd y;  ///< as x; what is not finite leaves a gap
  Pen pen;
  bool joined = true;
};

struct PlaneSpot {
  double x = 0.0;
  double y = 0.0;
  char32_t glyph = U'●';
  Style style;
  std::string label = {};  ///< written beside it where there is room
};

struct PlanePlot {
  std::string title;
  std::string x_label;  ///< with its unit
  std::string y_label;
  std::vector<Path> paths;
  std::vector<PlaneSpot> spots;
};

/// Fitted to the first path (all others are drawn where they fall), with the
/// axes through zero and ticks at the edges. At least 16 x 6 cells, else
/// nothing.
void draw_plane(Screen& screen, const Rect& rect, const PlanePlot& plot);

}  // namespace tapfit::tui
