// Pictures: where lines, bars, cells and points come to lie.
#include "tests/tui/support/holds.hpp"
#include "tui/document/svg_bars.hpp"
#include "tui/document/svg_canvas.hpp"
#include "tui/document/svg_heat_map.hpp"
#include "tui/document/svg_plot.hpp"
#include "tui/document/svg_structure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <string>

namespace tapfit::tui {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

long count(const std::string& text, const std::string& part) {
  long found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

bool has_no_number_that_is_none(const std::string& svg) {
  return !holds(svg, "nan") && !holds(svg, "inf");
}

Plot line_plot(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  Plot plot;
  plot.title = "line";
  plot.x = {"f", "Hz", 0.0, 0.0, false};
  plot.y = {"|H|", "", 0.0, 0.0, false};
  plot.curves = {{"measured", x, y, {}, {}, {}}};
  return plot;
}

TEST(Coordinate, HasOneDecimalAtMost) {
  EXPECT_EQ(coordinate(12.04), "12");
  EXPECT_EQ(coordinate(12.06), "12.1");
  EXPECT_EQ(coordinate(-0.04), "0");
  EXPECT_EQ(coordinate(not_a_number), "0");
}

// The frame is 62 px from the left and 14 px from the right of 680.
TEST(SvgPlot, TheEndsOfACurveAreTheEndsOfTheAxis) {
  Plot plot = line_plot(Eigen::Vector2d(0, 10), Eigen::Vector2d(0, 1));
  plot.y = {"", "", 0.0, 1.0, false};
  const std::string svg = svg_plot(plot);
  EXPECT_TRUE(holds(svg, "<path d=\"M62 276L666 32\"")) << svg;
  EXPECT_TRUE(holds(svg, ">measured</text>"));
  EXPECT_TRUE(holds(svg, ">f [Hz]</text>"));
}

// A tenth of two decades down is half way.
TEST(SvgPlot, ALogarithmicAxisCountsDecades) {
  Plot plot =
      line_plot(Eigen::Vector3d(0, 5, 10), Eigen::Vector3d(0.01, 0.1, 1.0));
  plot.y = {"", "", 0.01, 1.0, true};
  EXPECT_TRUE(holds(svg_plot(plot), "M62 276L364 154 666 32"));
}

// From 0.5 to 2 and back on an axis up to 1: it leaves after a third.
TEST(SvgPlot, ACurveIsCutWhereItLeavesTheFrame) {
  Plot plot =
      line_plot(Eigen::Vector3d(0, 5, 10), Eigen::Vector3d(0.5, 2.0, 0.5));
  plot.y = {"", "", 0.0, 1.0, false};
  EXPECT_TRUE(holds(svg_plot(plot), "M62 154L162.7 32M565.3 32L666 154"))
      << svg_plot(plot);
  plot.curves[0].y = Eigen::Vector3d(-1.0, 2.0, 2.0);
  EXPECT_TRUE(holds(svg_plot(plot), "M162.7 276L263.3 32\"")) << svg_plot(plot);
}

TEST(SvgPlot, WhatCannotBeDrawnIsAGap) {
  Eigen::VectorXd y(5);
  y << 1.0, 2.0, not_a_number, 2.0, 1.0;
  const std::string svg =
      svg_plot(line_plot(Eigen::VectorXd::LinSpaced(5, 0.0, 4.0), y));
  EXPECT_TRUE(has_no_number_that_is_none(svg)) << svg;
  const std::size_t curve = svg.find("stroke=\"#1a1a1a\"");
  const std::size_t begin = svg.rfind("<path", curve);
  EXPECT_EQ(count(svg.substr(begin, curve - begin), "M"), 2);
}

TEST(SvgPlot, NothingToDrawIsAnEmptyFrame) {
  const std::string svg = svg_plot(line_plot({}, {}));
  EXPECT_TRUE(has_no_number_that_is_none(svg));
  EXPECT_TRUE(holds(svg, "</svg>"));
}

// A peak of a single line among 100,000 is still as high.
TEST(SvgPlot, AThinnedCurveKeepsItsPeaks) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(100000);
  y(54321) = 1.0;
  Plot plot = line_plot(Eigen::VectorXd::LinSpaced(100000, 0.0, 1.0), y);
  plot.y = {"", "", 0.0, 1.0, false};
  const std::string svg = svg_plot(plot);
  EXPECT_LT(svg.size(), 20000U);
  EXPECT_TRUE(holds(svg, " 32 "));
}

// The picture is 310 px wide and 112 px high inside its margins and has 62 px
// on the left and 8 px above: the circle's radius is as long both ways.
TEST(SvgPlane, ACircleStaysOne) {
  PlanePlot plane;
  plane.paths = {{"",
                  Eigen::Vector4d(-1, 0, 1, 0),
                  Eigen::Vector4d(0, 1, 0, -1),
                  {},
                  true}};
  const std::string svg =
      svg_plane(plane, {62.0 + 310.0 + 14.0, 8.0 + 112.0 + 44.0});
  EXPECT_TRUE(holds(svg, "M167 64L217 14 267 64 217 114")) << svg;
  EXPECT_FALSE(holds(svg, "<rect"));
  plane.x_label = "Re H";
  EXPECT_TRUE(holds(svg_plane(plane), ">Re H</text>"));
}

TEST(SvgPlot, SaysWhatItsGlyphsMean) {
  Plot plot;
  plot.x = {"f", "Hz", 0.0, 10.0, false};
  plot.y = {"order", "", 0.0, 10.0, false};
  plot.spots = {{5.0, 4.0, U's', {}}};
  plot.meanings = {{U's', "stable pole"}, {U'o', "new pole"}};
  const std::string svg = svg_plot(plot, {});
  EXPECT_NE(svg.find("stable pole"), std::string::npos) << svg;
  EXPECT_EQ(svg.find("new pole"), std::string::npos) << svg;
}

TEST(SvgPlot, HasWhatTheScreenMarks) {
  Plot plot = line_plot(Eigen::Vector2d(0, 10), Eigen::Vector2d(0, 1));
  plot.y = {"", "", 0.0, 1.0, false};
  plot.markers.push_back({5.0});
  plot.spots.push_back({5.0, 0.5, U's', {.colour = Colour::Green}});
  const std::string svg = svg_plot(plot, {.titled = true});
  EXPECT_TRUE(holds(svg, ">line</text>")) << svg;
  EXPECT_TRUE(holds(svg, "M364 52L364 276")) << svg;
  EXPECT_TRUE(holds(svg, ">s</text>")) << svg;
}

// A trace that is known by its lowest and highest values alone.
TEST(SvgPlot, AnEnvelopeGoesFromItsLowerToItsHigherEnd) {
  Plot plot = line_plot({}, {});
  plot.y = {"", "", 0.0, 1.0, false};
  plot.curves = {{"",
                  Eigen::Vector2d(0, 10),
                  {},
                  Eigen::Vector2d(0, 0),
                  Eigen::Vector2d(1, 1),
                  {}}};
  EXPECT_TRUE(holds(svg_plot(plot), "M62 276L62 8 666 276 666 8"))
      << svg_plot(plot);
}

TEST(SvgBars, TheLargestGoesToTheEnd) {
  const std::string svg = svg_bars({{"base", 1.0, "100 %", ink::orange},
                                    {"after", 0.01, "1 %", ink::blue},
                                    {"none", 0.0, "–", ink::blue}},
                                   "ladder",
                                   "error [%]",
                                   100.0);
  EXPECT_TRUE(holds(svg, "width=\"348\"")) << svg;
  EXPECT_TRUE(holds(svg, ">100 %</text>"));
  EXPECT_TRUE(has_no_number_that_is_none(svg));
}

TEST(SvgHeatMap, LeavesOutWhatIsNoNumber) {
  SvgHeatMap map;
  map.values = Eigen::Matrix2d{{1.0, not_a_number}, {0.0, 0.5}};
  map.rows = {"1", "<2>"};
  map.columns = {"a", "b"};
  const std::string svg = svg_heat_map(map);
  EXPECT_EQ(count(svg, "<rect"), 3);
  EXPECT_TRUE(holds(svg, ">100</text>"));
  EXPECT_TRUE(holds(svg, "&lt;2&gt;"));
  EXPECT_TRUE(holds(svg, "#ffffff"));
}

// Beside each other, letters are of one size: maps of few and of more columns
// are as wide.
TEST(SvgHeatMap, IsAsWideForFewColumnsAsForMore) {
  SvgHeatMap map;
  for (const Eigen::Index columns : {2, 8}) {
    map.values = Eigen::MatrixXd::Zero(3, columns);
    EXPECT_TRUE(holds(svg_heat_map(map), "viewBox=\"0 0 420 ")) << columns;
  }
  map.values = Eigen::MatrixXd::Zero(3, 30);
  EXPECT_FALSE(holds(svg_heat_map(map), "viewBox=\"0 0 420 "));
}

// The title of the rows stands before them, long or short, and is not cut off
// where there are few.
TEST(SvgHeatMap, HasRoomForTheTitleOfItsRows) {
  SvgHeatMap map;
  map.values = Eigen::MatrixXd::Zero(1, 1);
  map.rows = {"1"};
  map.row_title = "response / hammer";
  const std::string svg = svg_heat_map(map);
  EXPECT_FALSE(holds(svg, "rotate"));
  // 17 letters of 7 px and 12 px, less the 6 px up to the cells.
  EXPECT_TRUE(holds(svg, "<text x=\"125\" y=\"14\"")) << svg;
}

// White on a colour that is half white cannot be read.
TEST(SvgHeatMap, WritesInWhiteOnDarkCellsAlone) {
  SvgHeatMap map;
  map.values = Eigen::RowVector2d(0.6, 1.0);
  const std::string svg = svg_heat_map(map);
  EXPECT_TRUE(holds(svg, "fill=\"#1a1a1a\">60</text>")) << svg;
  EXPECT_TRUE(holds(svg, "fill=\"#ffffff\">100</text>"));
}

// Where all that is shown is zero, nothing is dark.
TEST(SvgHeatMap, HasColoursWhereAllIsZero) {
  SvgHeatMap map;
  map.values = Eigen::Matrix2d::Zero();
  map.full = 0.0;
  EXPECT_EQ(count(svg_heat_map(map), "fill=\"#ffffff\""), 4)
      << svg_heat_map(map);
}

Wireframe square() {
  Wireframe wire;
  wire.points.resize(3, 4);
  wire.points << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  wire.lines = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  wire.ranks.assign(4, {0, true});
  wire.index = {{11, 0}, {12, 1}, {13, 2}, {14, 3}};
  return wire;
}

// Four edges round a square are one line of five points; the rest are axes.
TEST(SvgStructure, EdgesAreJoined) {
  const std::string svg =
      svg_structure(square(), {"set-up", {{12, "hit", ink::orange, 4.0}}});
  EXPECT_EQ(count(svg, "M"), 1 + 3) << svg;
  EXPECT_EQ(count(svg, "<circle"), 1);
  EXPECT_TRUE(holds(svg, ">hit</text>"));
}

// Seen from 35° above, an upright line of 24 px is 24 cos 35° = 19.7 px long.
TEST(SvgStructure, ShowsTheBasicAxes) {
  const std::string svg = svg_structure(square(), {"set-up", {}});
  for (const char* axis : {">X</text>", ">Y</text>", ">Z</text>"}) {
    EXPECT_EQ(count(svg, axis), 1) << axis;
  }
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      svg, found, std::regex(R"(d="M(\S+) (\S+)L\1 (\S+)\")")))
      << svg;
  EXPECT_NEAR(std::stod(found.str(2)) - std::stod(found.str(3)), 19.7, 0.11);
}

TEST(SvgStructure, PointsThatAreNotThereAreLeftOut) {
  const std::string svg =
      svg_structure(square(), {"set-up", {{99, "lost", ink::orange, 4.0}}});
  EXPECT_FALSE(holds(svg, "lost"));
}

// Both ways from rest by the same, and back.
TEST(SvgShape, SwingsBetweenTwoPathsOfTheSameCommands) {
  SvgShape shape;
  shape.name = "mode 1";
  shape.grids = Eigen::Matrix3Xd::Zero(3, 4);
  shape.grids(2, 2) = 0.5;
  shape.points = {{13, Eigen::Vector3d(0, 0, 0.5)}};
  const std::string svg = svg_shape(square(), shape);
  EXPECT_EQ(count(svg, "<animate "), 2);
  const std::size_t begin = svg.find("values=\"") + 8;
  const std::string values = svg.substr(begin, svg.find('"', begin) - begin);
  EXPECT_EQ(std::count(values.begin(), values.end(), ';'), 2);
  EXPECT_EQ(std::count(values.begin(), values.end(), 'M'), 3);
  EXPECT_EQ(values.substr(0, values.find(';')),
            values.substr(values.rfind(';') + 1));
}

TEST(SvgShape, AStructureOfOnePointHasASize) {
  Wireframe wire;
  wire.points = Eigen::Matrix3Xd::Zero(3, 1);
  wire.index = {{1, 0}};
  SvgShape shape;
  shape.points = {{1, Eigen::Vector3d(0, 0, 1)}};
  EXPECT_TRUE(has_no_number_that_is_none(svg_shape(wire, shape)));
}

}  // namespace
}  // namespace tapfit::tui
