// Shapes for ParaView against the mode shapes that they were made of.
#include "updating/export/shapes_vtu.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

namespace tapfit::updating {
namespace {

/// A square of one shell with a bar along its diagonal and a measured point of
/// the test's own, turned by 90 degrees about z.
structure::Deck square() {
  structure::Deck deck;
  deck.grids = {{11, {0, 0, 0}},
                {12, {1, 0, 0}},
                {13, {1, 1, 0}},
                {14, {0, 1, 0}},
                {-1, {0.5, 0.5, 0.1}}};
  structure::Shell shell;
  shell.grids = {11, 12, 13, 14};
  deck.shells = {shell};
  structure::Bar bar;
  bar.grids = {11, 13};
  deck.bars = {bar};
  structure::MeasuringPoint point;
  point.grid = -1;
  point.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  deck.measuring = {point};
  return deck;
}

ModelModes model_modes() {
  ModelModes modes;
  modes.frequency_hz = Eigen::Vector2d(5.0, 12.5);
  modes.at_grids = Eigen::MatrixXd::Random(15, 2);
  modes.at_dofs = Eigen::MatrixXd{{2.0, 0.0}, {4.0, 1.0}};
  return modes;
}

const Eigen::MatrixXd& data_of(const VtuMesh& mesh, const std::string& name) {
  const auto found = std::ranges::find(
      mesh.data, name, &std::pair<std::string, Eigen::MatrixXd>::first);
  if (found != mesh.data.end()) return found->second;
  throw std::runtime_error("no " + name);
}

TEST(ShapesVtu, TheMeshMovesAsTheModel) {
  const ModelModes modes = model_modes();
  const VtuMesh mesh = model_mesh(square(), modes);
  EXPECT_EQ(mesh.points.cols(), 5);
  ASSERT_EQ(mesh.cells.size(), 2U);
  EXPECT_EQ(mesh.cells[0].type, VtuCellType::Quad);
  EXPECT_EQ(mesh.cells[1].points, (std::vector<Eigen::Index>{0, 2}));
  EXPECT_EQ(data_of(mesh, "grid")(0, 3), 14);
  const Eigen::MatrixXd& second = data_of(mesh, "model 2, 12.5 Hz");
  for (Eigen::Index grid = 0; grid < 5; ++grid) {
    EXPECT_EQ(second.col(grid), modes.at_grids.col(1).segment(3 * grid, 3));
  }
}

// Two modes at one frequency, as symmetric structures have them.
TEST(ShapesVtu, ModesOfOneFrequencyHaveNamesOfTheirOwn) {
  ModelModes modes = model_modes();
  modes.frequency_hz(1) = modes.frequency_hz(0);
  const VtuMesh mesh = model_mesh(square(), modes);
  ASSERT_EQ(mesh.data.size(), 3U);
  EXPECT_NE(mesh.data[1].first, mesh.data[2].first);
}

TEST(ShapesVtu, FilesKeepThePointsOfTheirNames) {
  EXPECT_EQ(vtu_files("run.v2")[1], "run.v2-model.vtu");
  EXPECT_EQ(vtu_files("run.v2.pvd")[0], "run.v2.pvd");
}

// The measured mode 1 is half of the model's, so that it is doubled; mode 2 has
// no partner. Grid 12 moves along -Z, the other point along its own X.
TEST(ShapesVtu, PointsMoveAsMeasuredOnTheModelsScale) {
  modal::ModeSet modes;
  modes.dofs = {{12, 3, -1}, {-1, 1, 1}};
  modes.modes.resize(2);
  modes.modes[0].shape = Eigen::Vector2cd(1.0, 2.0);
  modes.modes[1].shape = Eigen::Vector2cd(0.0, 1.0);
  modes.modes[1].frequency_hz = 31.0;
  Comparison comparison;
  comparison.modes = model_modes();
  comparison.pairs = {{.measured = 0, .model = 0}};
  comparison.point_error = {{12, 0.25},
                            {-1, std::numeric_limits<double>::quiet_NaN()}};
  const VtuMesh mesh = points_mesh(square(), modes, comparison);
  ASSERT_EQ(mesh.points.cols(), 2);
  EXPECT_EQ(mesh.points.col(1), Eigen::Vector3d(0.5, 0.5, 0.1));
  EXPECT_EQ(data_of(mesh, "error"), Eigen::RowVector2d(0.25, 0.0));
  const Eigen::MatrixXd& first = data_of(mesh, "model 1, 5 Hz");
  EXPECT_TRUE(first.col(0).isApprox(Eigen::Vector3d(0, 0, -2)));
  EXPECT_TRUE(first.col(1).isApprox(Eigen::Vector3d(0, 4, 0)));
  EXPECT_EQ(data_of(mesh, "measured 2, 31 Hz").col(0), Eigen::Vector3d::Zero());
}

// "VTK File Formats": one line per point, offsets are the ends of the cells.
TEST(VtuText, IsAFileOfVtk) {
  VtuMesh mesh;
  mesh.points = Eigen::Matrix3Xd{{0, 1, 1}, {0, 0, 1}, {0, 0, 0.5}};
  mesh.cells = {{VtuCellType::Triangle, {0, 1, 2}},
                {VtuCellType::Line, {0, 2}}};
  mesh.data = {{"a < b", Eigen::RowVector3d(1, 2, 3)}};
  const std::string text = vtu_text(mesh);
  for (const char* part :
       {"<Piece NumberOfPoints=\"3\" NumberOfCells=\"2\">",
        "NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0\n1 0 0\n1 1 0.5\n</",
        "Name=\"connectivity\" format=\"ascii\">\n0 1 2 \n0 2 \n</",
        "Name=\"offsets\" format=\"ascii\">\n3\n5\n</",
        "Name=\"types\" format=\"ascii\">\n5\n3\n</",
        "Name=\"a &lt; b\" NumberOfComponents=\"1\" "
        "format=\"ascii\">\n1\n2\n3\n",
        "</VTKFile>\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  EXPECT_NE(
      pvd_text({"a.vtu", "b.vtu"}).find("<DataSet part=\"1\" file=\"b.vtu\"/>"),
      std::string::npos);
}

TEST(ShapesVtu, HasThreeFilesOfOneName) {
  EXPECT_EQ(vtu_files("some/shapes.vtu"),
            (std::vector<std::filesystem::path>{"some/shapes.pvd",
                                                "some/shapes-model.vtu",
                                                "some/shapes-points.vtu"}));
}

}  // namespace
}  // namespace tapfit::updating
