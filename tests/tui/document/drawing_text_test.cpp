// Numbers of what is drawn: which of them, under which names.
#include "tui/document/drawing_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tapfit::tui {
namespace {

Plot two_curves() {
  Plot plot;
  plot.x = {"f", "Hz", 0.0, 0.0, false};
  plot.y = {"|H|", "m/N", 0.0, 0.0, true};
  const Eigen::Vector3d f(1, 2, 3);
  plot.curves = {{"measured",
                  f,
                  Eigen::Vector3d(10, 20, 30),
                  Eigen::Vector3d(9, 19, 29),
                  Eigen::Vector3d(11, 21, 31),
                  {}},
                 {"model", f, Eigen::Vector3d(1, 2, 3), {}, {}, {}}};
  return plot;
}

TEST(DrawingTable, CurvesOnTheSameLinesShareTheirColumn) {
  EXPECT_EQ(drawing_table(two_curves()),
            "f [Hz],measured [m/N],measured low [m/N],measured high [m/N],"
            "model [m/N]\n"
            "1,10,9,11,1\n2,20,19,21,2\n3,30,29,31,3\n");
}

TEST(DrawingTable, HoldsTheStretchThatIsDrawn) {
  Plot plot = two_curves();
  plot.curves.erase(plot.curves.begin());
  plot.x.lo = 1.5;
  plot.x.hi = 2.5;
  EXPECT_EQ(drawing_table(plot), "f [Hz],model [m/N]\n2,2\n");
}

TEST(DrawingTable, NamesCurvesWithoutANameAndPoints) {
  Plot plot = two_curves();
  plot.y = {"phase", "deg", 0.0, 0.0, false};
  plot.curves = {
      {"", Eigen::Vector2d(1, 2), Eigen::Vector2d(5, 6), {}, {}, {}},
      {"", Eigen::Vector2d(3, 4), Eigen::Vector2d(7, 8), {}, {}, {}}};
  plot.spots.push_back({1.0, 4.0, U's', {}});
  EXPECT_EQ(drawing_table(plot),
            "f [Hz],phase [deg],f [Hz],phase 2 [deg],s f [Hz],s phase [deg]\n"
            "1,5,3,7,1,4\n2,6,4,8,,\n");
}

TEST(DrawingTable, HoldsWhatCurvesAndGlyphsStandFor) {
  Plot plot = two_curves();
  plot.curves.erase(plot.curves.begin());
  plot.curves[0].quantity = "CMIF 1 [m/N]";
  plot.curves[0].numbers = Eigen::Vector3d(7, 8, 9);
  plot.y = {"order", "", 0.0, 0.0, false};
  plot.spots.push_back({1.0, 4.0, U's', {}});
  plot.meanings = {{U's', "stable pole"}};
  EXPECT_EQ(drawing_table(plot),
            "f [Hz],CMIF 1 [m/N],stable pole f [Hz],stable pole order\n"
            "1,7,1,4\n2,8,,\n3,9,,\n");
}

TEST(DrawingTable, APlaneHasBothCoordinates) {
  PlanePlot plane;
  plane.x_label = "Re H [m/N]";
  plane.y_label = "Im H [m/N]";
  plane.paths = {{"", Eigen::Vector2d(1, 2), Eigen::Vector2d(3, 4), {}, true}};
  EXPECT_EQ(drawing_table(plane, '\t'), "Re H [m/N]\tIm H [m/N]\n1\t3\n2\t4\n");
  // A picture of the structure has nothing that could be read off.
  plane.x_label.clear();
  EXPECT_EQ(drawing_table(plane), "");
}

// As on the screen: in per cent, without the modes of a rigid body.
TEST(DrawingTable, AMatrixHasItsNames) {
  HeatMap map;
  map.title = "MAC in %";
  map.values = Eigen::Matrix<double, 2, 3>{{1, 0.5, 0}, {0, 0.25, 1}};
  map.row_names = {"5.00", "17.50"};
  map.column_names = {"0", "5.1", "18"};
  map.first = 1;
  EXPECT_EQ(drawing_table(map), "MAC in %,5.1,18\n5.00,50,0\n17.50,25,100\n");
  map.shortfall = true;
  map.values(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(drawing_table(map), "MAC in %,5.1,18\n5.00,,0\n17.50,0.25,1\n");
}

TEST(DrawingPicture, HasATitle) {
  for (const Drawing& drawing :
       {Drawing(two_curves()), Drawing(PlanePlot()), Drawing(HeatMap())}) {
    const std::string svg = drawing_picture(drawing);
    EXPECT_TRUE(svg.starts_with("<svg")) << svg;
    EXPECT_TRUE(svg.ends_with("</svg>")) << svg;
  }
  Plot plot = two_curves();
  plot.title = "285Z+ / 285Z+";
  EXPECT_NE(drawing_picture(plot).find(">285Z+ / 285Z+</text>"),
            std::string::npos);
}

}  // namespace
}  // namespace tapfit::tui
