// The room tui/widgets. What screens are put together from: plots, tables,
// bars, heat maps, the wireframe.
// In:  Numbers and a rectangle.
// Out: Cells in a screen.
// May include: its row in CONTRIBUTING.md.
//
// Line plots in cells: axes with ticks and units, linear or logarithmic,
// several curves, bands around them, shaded stretches, markers and a cursor.
#pragma once

#include "tui/screen/dots.hpp"
#include "tui/screen/screen.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

struct Axis {
  std::string label;
  std::string unit;
  double lo = 0.0;  ///< lo >= hi: fitted to what the curves show
  double hi = 0.0;
  bool log = false;
};

/// Points in rising x. Values that are not finite (or not positive on a
/// logarithmic axis) leave a gap.
struct Curve {
  std::string label;
  Eigen::VectorXd x;
  Eigen::VectorXd y;     ///< as x, or empty when there is only a band
  Eigen::VectorXd low;   ///< as x, or empty: band drawn from low ...
  Eigen::VectorXd high;  ///< ... to high
  Pen pen;
};

struct Marker {
  double x = 0.0;
  char32_t glyph = U'▼';  ///< drawn at the plot's upper edge
  Style style;
};

/// A point drawn as one glyph (stabilisation letters, hits).
struct Spot {
  double x = 0.0;
  double y = 0.0;
  char32_t glyph = U'o';
  Style style;
};

struct Shade {
  double from = 0.0;
  double to = 0.0;
  Style style;
};

struct Plot {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<Marker> markers;
  std::vector<Spot> spots;
  std::vector<Shade> shades;
  std::optional<double> cursor;  ///< x of the cursor line
  bool x_labels = true;          ///< the axis line and its labels below
};

/// Axes with their ranges filled in: never empty, always finite, positive on
/// a logarithmic axis (at most 8 decades), a constant curve in the middle.
struct Ranges {
  Axis x;
  Axis y;
};
[[nodiscard]] Ranges fit_ranges(const Plot& plot);

/// Draws into the rectangle; at least 12 x 4 cells, else nothing.
void draw_plot(Screen& screen, const Rect& rect, const Plot& plot);

/// "f 12.5 Hz: measured 3.21, model 2.98 (m/s²)/N": what lies under x, each
/// curve at its point nearest to x; curves without a value are left out.
[[nodiscard]] std::string read_out(const Plot& plot, double x);

}  // namespace tapfit::tui
