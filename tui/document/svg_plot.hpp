// Curves over two axes as an SVG picture, with ticks and a legend.
#pragma once

#include "tui/document/svg_canvas.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::tui {

struct SvgAxis {
  std::string title;  ///< with its unit
  bool log = false;
  double low = 0.0;
  double high = 0.0;  ///< not above low: from what is drawn
};

struct SvgCurve {
  std::string label;  ///< empty: not in the legend
  Eigen::VectorXd x;
  Eigen::VectorXd y;  ///< a value that cannot be drawn is a gap
  Stroke stroke;
  bool dots = false;  ///< not joined by lines
};

struct SvgPlot {
  std::string name;  ///< what it shows
  SvgAxis x;
  SvgAxis y;
  std::vector<SvgCurve> curves;
  std::vector<double> upright;  ///< thin lines at these x, behind the curves
  double width = 680.0;         ///< [px]
  double height = 320.0;
};

/// A curve of more points than the picture has columns keeps the lowest and the
/// highest of each column.
[[nodiscard]] std::string svg_plot(const SvgPlot& plot);

}  // namespace tapfit::tui
