// What is plotted, as numbers: curves over two axes, paths in a plane, matrices
// of coloured numbers. Screens draw them in cells, pictures and tables are made
// of the same.
#pragma once

#include "tui/screen/dots.hpp"
#include "tui/screen/screen.hpp"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <variant>
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
  bool joined = true;  ///< by lines; else single dots
  /// For tables, where y is laid into the scale of another quantity: what it
  /// stands for, and as x.
  std::string quantity = {};  ///< with its unit
  Eigen::VectorXd numbers = {};
};

struct Marker {
  double x = 0.0;
  char32_t glyph = U'▼';  ///< drawn at the plot's upper edge
  Style style = {};
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
  /// What the glyphs of spots stand for, where they say it in tables.
  std::map<char32_t, std::string> meanings = {};
};

/// Numbers under their heading.
struct NamedNumbers {
  std::string heading;
  Eigen::VectorXd values;  ///< what is not finite leaves its cell empty
};

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
  std::string x_label;  ///< with its unit; both empty: a picture without axes
  std::string y_label;
  std::vector<Path> paths;
  std::vector<PlaneSpot> spots;
  /// For tables, where paths are only a view of it.
  std::vector<NamedNumbers> columns = {};
};

struct HeatMap {
  std::string title;  ///< written by those who draw it
  Eigen::MatrixXd values;
  std::vector<std::string> row_names;
  std::vector<std::string> column_names;
  double scale = 1.0;  ///< the value that is shown hottest
  double cold = 0.0;   ///< and the one up to which there is no heat
  int top = 0;         ///< first row shown
  int left = 0;        ///< first column shown
  int first = 0;       ///< columns before it are not for show
  int selected = -1;   ///< row to mark
  int column = -1;     ///< entry of that row to mark
  /// The other way round: 1 is cold, 1 - scale hottest (coherence, MAC of
  /// pairs); entries then have three decimals where there is room for them.
  bool shortfall = false;
  int entry_width = 5;  ///< cells per entry, 4 at least
};

using Drawing = std::variant<Plot, PlanePlot, HeatMap>;

/// What a screen shows, in the order it is drawn.
struct Drawings {
  std::vector<Drawing> shown;
};

/// Keeps it where the drawings are asked for.
template <class Kind>
void keep_drawing(const Screen& screen, const Kind& drawn) {
  if (Drawings* drawings = screen.drawings())
    drawings->shown.emplace_back(drawn);
}

}  // namespace tapfit::tui
