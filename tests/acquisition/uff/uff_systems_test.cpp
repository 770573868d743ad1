#include "acquisition/uff/uff_systems.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"
#include "tests/support/matchers.hpp"

#include <fmt/format.h>

#include <sstream>

namespace tapfit::acquisition {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

UffGeometry geometry_in(const std::string& text) {
  return read_geometry(split_uff(text, "test.uff"));
}

std::string dataset(int type, const std::string& body) {
  return fmt::format("    -1\n{:6}\n{}    -1\n", type, body);
}

std::string system_18(int label, int kind, int reference, const Matrix3d& p) {
  std::string text = fmt::format(
      "{:10}{:10}{:10}{:10}{:10}\nCS\n", label, kind, reference, 8, 1);
  for (int k = 0; k < 9; ++k) {
    text += fmt::format("{:13.5E}", p.data()[k]);
    if (k == 5 || k == 8) text += "\n";
  }
  return text;
}

std::string node_15(int label, int definition, int displacement, Vector3d x) {
  return fmt::format("{:10}{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n",
                     label,
                     definition,
                     displacement,
                     8,
                     x.x(),
                     x.y(),
                     x.z());
}

// Turned by 30 degrees about z, its origin at (1, 2, 3).
const Matrix3d thirty = [] {
  Matrix3d p;
  const double c = std::sqrt(0.75);
  p << 1.0, 1.0 + c, 1.0, 2.0, 2.5, 2.0, 3.0, 3.0, 4.0;
  return p;
}();

TEST(UffSystems, CoordinatesAndDirectionsCountInTheNodesSystems) {
  const UffGeometry g =
      geometry_in(dataset(15, node_15(7, 3, 3, {2.0, 0.0, 0.5})) +
                  dataset(18, system_18(3, 0, 0, thirty)));
  const double c = std::sqrt(0.75);
  EXPECT_TRUE(position_of(g, 7).isApprox(Vector3d(1 + 2 * c, 3.0, 3.5), 1e-5));
  const Matrix3d axes = directions_at(g, 7);
  EXPECT_TRUE(axes.col(0).isApprox(Vector3d(c, 0.5, 0.0), 1e-5));
  EXPECT_TRUE(axes.col(1).isApprox(Vector3d(-0.5, c, 0.0), 1e-5));
  EXPECT_TRUE(axes.col(2).isApprox(Vector3d(0.0, 0.0, 1.0), 1e-5));
  // Askew: a point of its own.
  EXPECT_EQ(turned(g, {7, 1, -1}), (Dof{-7, 1, -1}));
  EXPECT_EQ(turned(g, {8, 1, -1}), (Dof{8, 1, -1}));
}

TEST(UffSystems, ASystemMayCountInAnother) {
  Matrix3d plain;  // origin (1, 0, 0) of the other, the same axes
  plain << 1, 2, 1, 0, 0, 0, 0, 0, 1;
  const UffGeometry g = geometry_in(
      dataset(18, system_18(4, 0, 3, plain) + system_18(3, 0, 0, thirty)) +
      dataset(15, node_15(1, 4, 0, {0.0, 0.0, 0.0})));
  EXPECT_TRUE(position_of(g, 1).isApprox(
      Vector3d(1.0 + std::sqrt(0.75), 2.5, 3.0), 1e-5));
}

TEST(UffSystems, ACylinderTurnsWithTheNode) {
  const Matrix3d plain = (Matrix3d() << 0, 1, 0, 0, 0, 0, 0, 0, 1).finished();
  const UffGeometry g =
      geometry_in(dataset(18, system_18(2, 1, 0, plain)) +
                  dataset(15, node_15(5, 2, 2, {0.5, 90.0, 0.0})));
  EXPECT_TRUE(position_of(g, 5).isApprox(Vector3d(0.0, 0.5, 0.0), 1e-6));
  // r is +Y there, theta is -X: basic directions.
  EXPECT_EQ(turned(g, {5, 1, 1}), (Dof{5, 2, 1}));
  EXPECT_EQ(turned(g, {5, 2, 1}), (Dof{5, 1, -1}));
  EXPECT_EQ(turned(g, {5, 4, -1}), (Dof{5, 5, -1}));
}

TEST(UffSystems, WhatIsWrittenComesBack) {
  UffGeometry g;
  const int label = uff_label(-3);
  EXPECT_EQ(node_of_uff_label(label), -3);
  EXPECT_EQ(node_of_uff_label(12), 12);
  g.nodes = {{12, {0.1, 0.2, 0.3}}, {label, {0.4, 0.5, 0.6}}};
  g.node_systems[label] = {0, label, {}};
  g.systems[label].points = thirty;
  for (const UffNodes as : {UffNodes::D15, UffNodes::D2411}) {
    std::ostringstream out;
    write_geometry(g, as, out);
    const UffGeometry back = geometry_in(out.str());
    EXPECT_TRUE(position_of(back, label).isApprox(g.nodes[label], 1e-5));
    EXPECT_TRUE(
        directions_at(back, label).isApprox(directions_at(g, label), 1e-12));
    EXPECT_TRUE(directions_at(back, 12).isIdentity(0.0));
    EXPECT_EQ(turned(back, {label, 3, 1}), (Dof{-3, 3, 1}));
  }
}

void refused(const std::string& text, const std::string& what) {
  try {
    const UffGeometry g = geometry_in(text);
    (void)turned(g, {1, 3, 1});
    ADD_FAILURE() << "accepted, expected: " << what;
  } catch (const InputError& error) {
    EXPECT_THAT(error.fault(), HasSubstr(what)) << error.what();
    EXPECT_THAT(error.where(), HasSubstr("test.uff")) << error.what();
    EXPECT_GT(error.remedy().size(), 10U);
  }
}

TEST(UffSystems, WhatCannotBeHonouredIsRefused) {
  const std::string node = dataset(15, node_15(1, 0, 9, {0.0, 0.0, 0.0}));
  refused(node, "coordinate system 9 is not in the file");
  refused(node + dataset(18, system_18(9, 0, 9, thirty)), "ring");
  refused(node + dataset(18, system_18(9, 5, 0, thirty)), "none of 0, 1, 2");
  refused(node + dataset(18, system_18(9, 0, 0, Matrix3d::Zero())),
          "on a line");
  const std::string row =
      fmt::format("{:25.16E}{:25.16E}{:25.16E}\n", 1., 0., 0.);
  refused(node + dataset(2420,
                         fmt::format(
                             "{:10}\npart\n{:10}{:10}{:10}\nCS\n", 1, 9, 0, 8) +
                             row + row + row + row),
          "right-handed unit vectors");
}

// Number 1 is the global system of programs that do not write it.
TEST(UffSystems, OneIsGlobalWhereItIsNotDefined) {
  const UffGeometry g =
      geometry_in(dataset(15, node_15(1, 1, 1, {0.1, 0.0, 0.0})));
  EXPECT_EQ(turned(g, {1, 3, -1}), (Dof{1, 3, -1}));
}

}  // namespace
}  // namespace tapfit::acquisition
