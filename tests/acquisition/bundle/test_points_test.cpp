// Points of a test's own in test.json: coordinates, directions, heights.
#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace tapfit::acquisition {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

class TestPoints : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("model.bdf", "");
    folder_.write("run.wav", "");
    document_ = json::parse(R"({
      "tapfit": 1, "model": "model.bdf",
      "channels": [
        {"name": "hammer", "quantity": "force", "unit": "N",
         "sensitivity": 1, "full_scale_volts": 5},
        {"name": "x", "quantity": "acceleration", "unit": "m/s^2",
         "sensitivity": 1, "full_scale_volts": 5},
        {"name": "y", "quantity": "acceleration", "unit": "m/s^2",
         "sensitivity": 1, "full_scale_volts": 5},
        {"name": "z", "quantity": "acceleration", "unit": "m/s^2",
         "sensitivity": 1, "full_scale_volts": 5}],
      "runs": [{"file": "run.wav",
        "hammer": {"channel": "hammer", "node": 3, "direction": "+Z"},
        "sensors": [{"channel": "x", "point": "3:+Z"}]}]})");
  }
  // Sensors x, y, z at these points.
  TestBundle read(const std::vector<json>& points) {
    json& sensors = document_["runs"][0]["sensors"];
    sensors = json::array();
    const std::string names = "xyz";
    for (std::size_t k = 0; k < points.size(); ++k) {
      sensors.push_back(
          {{"channel", names.substr(k, 1)}, {"point", points[k]}});
    }
    return read_now();
  }
  TestBundle read_now() {
    folder_.write("test.json", document_.dump());
    return read_test_bundle(folder_.path());
  }
  void refuses(const json& point,
               const std::string& where,
               const std::string& what) {
    try {
      (void)read({point});
      ADD_FAILURE() << "accepted " << point;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), "test.json: runs[0].sensors[0]" + where)
          << error.what();
      EXPECT_THAT(error.what(), HasSubstr(what));
      EXPECT_GT(error.remedy().size(), 10U);
    }
  }
  // The direction that a degree of freedom means.
  static Vector3d along(const TestBundle& bundle, const Dof& dof) {
    const TestPoint* point = find_point(bundle.points, -dof.node);
    return dof.sign * point->axes.col(dof.component - 1);
  }
  testing::TemporaryFolder folder_;
  json document_;
};

TEST_F(TestPoints, ABasicDirectionAtAGridIsThatGrids) {
  const TestBundle bundle =
      read({json{{"node", 12}, {"direction", "-X"}},
            json{{"node", 12}, {"direction", {0, 2, 0}}}});
  EXPECT_EQ(bundle.runs[0].sensors[0].dof, (Dof{12, 1, -1}));
  EXPECT_EQ(bundle.runs[0].sensors[1].dof, (Dof{12, 2, 1}));
  EXPECT_TRUE(bundle.points.empty());
}

// What points mostly along -Z is called Z-.
TEST_F(TestPoints, ASkewDirectionIsAPointOfItsOwn) {
  const TestBundle bundle =
      read({json{{"node", 12}, {"direction", {3, 0, -4}}}});
  const Dof dof = bundle.runs[0].sensors[0].dof;
  EXPECT_EQ(name(dof), "P1Z-");
  ASSERT_EQ(bundle.points.size(), 1U);
  EXPECT_EQ(bundle.points[0].node, 12);
  EXPECT_TRUE(along(bundle, dof).isApprox(Vector3d(0.6, 0.0, -0.8), 1e-14));
  EXPECT_NEAR(bundle.points[0].axes.determinant(), 1.0, 1e-14);
}

// Three channels at right angles are one sensor, in whatever order.
TEST_F(TestPoints, ATriaxialSensorIsOnePoint) {
  const json at = {0.1, 0.2, 0.0};
  const auto point = [&at](const json& d) {
    return json{{"at", at}, {"direction", d}};
  };
  const TestBundle bundle = read(
      {point({0.6, 0.0, 0.8}), point({-0.8, 0.0, 0.6}), point({0, -1, 0})});
  ASSERT_EQ(bundle.points.size(), 1U);
  EXPECT_TRUE(bundle.points[0].at->isApprox(Vector3d(0.1, 0.2, 0.0)));
  const auto& s = bundle.runs[0].sensors;
  EXPECT_EQ(name(s[0].dof), "P1Z+");
  EXPECT_EQ(name(s[1].dof), "P1X-");
  EXPECT_EQ(name(s[2].dof), "P1Y-");
  EXPECT_TRUE(along(bundle, s[0].dof).isApprox(Vector3d(0.6, 0.0, 0.8), 1e-14));
  EXPECT_TRUE(along(bundle, s[1].dof).isApprox(Vector3d(-0.8, 0, 0.6), 1e-14));
  EXPECT_TRUE(along(bundle, s[2].dof).isApprox(Vector3d(0.0, -1, 0.0), 1e-14));
  // Not at right angles: another sensor.
  EXPECT_EQ(read({point({0, 0, 1}), point({0.6, 0, 0.8})}).points.size(), 2U);
}

// Two turns of 30 and 45 degrees, as a sheet says them.
TEST_F(TestPoints, ATriaxialSensorMayBeRoundedToThreeDigits) {
  const double a = std::sqrt(0.375);
  const double b = std::sqrt(0.125);
  const double c = std::sqrt(0.5);
  const std::vector<Vector3d> exact = {
      {a, b, c}, {-0.5, std::sqrt(0.75), 0.0}, {-a, -b, c}};
  std::vector<json> points;
  for (const Vector3d& d : exact) {
    json rounded = json::array();
    for (const double x : d) rounded.push_back(std::round(1e3 * x) / 1e3);
    points.push_back({{"at", {0.1, 0.2, 0.0}}, {"direction", rounded}});
  }
  std::vector<std::size_t> order = {0, 1, 2};
  do {
    const TestBundle bundle =
        read({points[order[0]], points[order[1]], points[order[2]]});
    ASSERT_EQ(bundle.points.size(), 1U);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d found = along(bundle, bundle.runs[0].sensors[k].dof);
      EXPECT_LT((found - exact[order[k]]).norm(), 2.5e-3);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_F(TestPoints, HeightsAreTheChannelsOrThePoints) {
  document_["channels"][1]["height_m"] = 0.008;
  document_["channels"][2]["height_m"] = 0.008;
  const TestBundle bundle =
      read({json("12:+X"),
            json{{"node", 12}, {"direction", "+X"}, {"height_m", 0}}});
  ASSERT_EQ(bundle.points.size(), 1U);
  EXPECT_EQ(bundle.points[0].height_m, 0.008);
  EXPECT_EQ(name(bundle.runs[0].sensors[0].dof), "P1X+");
  EXPECT_EQ(name(bundle.runs[0].sensors[1].dof), "12X+");
}

TEST_F(TestPoints, CoordinatesAreInTheModelsUnit) {
  document_["units"] = "mm-t-s";
  const TestBundle bundle =
      read({json{{"at", {100, 200, 5}}, {"direction", "+Z"}}});
  ASSERT_EQ(bundle.points.size(), 1U);
  EXPECT_TRUE(bundle.points[0].at->isApprox(Vector3d(0.1, 0.2, 0.005), 1e-14));
}

TEST_F(TestPoints, WhatIsWrittenComesBack) {
  document_["units"] = "mm-t-s";
  const TestBundle bundle =
      read({json{{"at", {100, 200, 5}},
                 {"direction", {0, 3, -4}},
                 {"height_m", 0.01}},
            json{{"node", 12}, {"direction", {1, 1, 1}}},
            json{{"node", 7}, {"direction", {{"system", 3}, {"axis", "-Y"}}}}});
  folder_.write("test.json", test_bundle_text(bundle, folder_.path()));
  const TestBundle back = read_test_bundle(folder_.path());
  ASSERT_EQ(back.points.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(back.runs[0].sensors[k].dof, bundle.runs[0].sensors[k].dof);
    ASSERT_EQ(back.points[k].at.has_value(), k == 0);
    if (k == 0) {
      EXPECT_TRUE(back.points[k].at->isApprox(*bundle.points[k].at, 1e-14));
    }
    EXPECT_TRUE(back.points[k].axes.isApprox(bundle.points[k].axes, 1e-12));
    EXPECT_EQ(back.points[k].height_m, bundle.points[k].height_m);
    EXPECT_EQ(back.points[k].system, bundle.points[k].system);
  }
}

TEST_F(TestPoints, WhatIsNoPlaceIsRefused) {
  refuses(json{{"at", {0, 0, 0}}, {"direction", {0, 0, 0}}},
          ".point.direction",
          "no length");
  refuses(json{{"at", {0, 0, 0}}, {"node", 3}, {"direction", "+Z"}},
          ".point",
          "or two");
  refuses(json{{"direction", "+Z"}}, ".point", "no place");
  refuses(json{{"node", 3}, {"direction", "+W"}},
          ".point.direction",
          "no direction");
  refuses(json{{"node", 3}, {"direction", {{"system", 3}, {"axis", "Q"}}}},
          ".point.direction.axis",
          "no direction");
}

class TestMesh : public TestPoints {
 protected:
  void SetUp() override {
    TestPoints::SetUp();
    folder_.write("mesh.csv",
                  "label,x,y,z\n1,0,0,0\n2,1,0,0\n3,0,1,0\n9,1,1,0\n");
    document_["geometry"] = {{"file", "mesh.csv"},
                             {"pairs", {{1, 101}, {2, 102}, {3, {0.5, 1, 0}}}}};
  }
  void refuses_geometry(const std::string& where, const std::string& what) {
    EXPECT_THAT(
        [&] { (void)read_now(); },
        Throws<InputError>(AllOf(Property(&InputError::where, where),
                                 Property(&InputError::what, HasSubstr(what)))))
        << "accepted, expected: " << what;
  }
};

TEST_F(TestMesh, NodesAreThePointsOfItsOwnMesh) {
  const TestBundle bundle =
      read({json("9:-Z"), json{{"node", 9}, {"direction", {1, 0, 1}}}});
  ASSERT_TRUE(bundle.geometry.has_value());
  ASSERT_EQ(bundle.geometry->pairs.size(), 3U);
  EXPECT_EQ(bundle.geometry->pairs[1].grid, 102);
  EXPECT_EQ(bundle.geometry->pairs[2].grid, 0);
  EXPECT_EQ(name(bundle.runs[0].hammer.dof), "P3Z+");
  EXPECT_EQ(name(bundle.runs[0].sensors[0].dof), "P9Z-");
  // A direction of its own gets a label behind those of the mesh.
  EXPECT_LT(bundle.runs[0].sensors[1].dof.node, -9);
  const TestPoint* point = find_point(bundle.points, 9);
  ASSERT_NE(point, nullptr);
  EXPECT_EQ(point->of_node, 9);
  EXPECT_TRUE(point->at->isApprox(Vector3d(1, 1, 0)));
}

TEST_F(TestMesh, WhatIsWrittenComesBack) {
  const TestBundle bundle =
      read({json("9:-Z"),
            json{{"node", 9}, {"direction", {1, 0, 1}}},
            json{{"node", 2}, {"direction", "+X"}, {"height_m", 0.01}}});
  folder_.write("test.json", test_bundle_text(bundle, folder_.path()));
  const TestBundle back = read_test_bundle(folder_.path());
  EXPECT_EQ(back.runs[0].hammer.dof, bundle.runs[0].hammer.dof);
  for (std::size_t k = 0; k < 3; ++k) {
    const Dof& dof = back.runs[0].sensors[k].dof;
    EXPECT_EQ(dof, bundle.runs[0].sensors[k].dof);
    EXPECT_EQ(find_point(back.points, -dof.node)->of_node, k == 2 ? 2 : 9);
  }
}

// A universal file of one node at the origin with axes turned about Z.
std::string turned_node(int label, double degrees) {
  const double a = degrees * M_PI / 180.0;
  UffGeometry geometry;
  geometry.nodes[label] = Vector3d::Zero();
  geometry.node_systems[label] = {0, 7, {}};
  geometry.systems[7].points << Vector3d::Zero(),
      Vector3d(std::cos(a), std::sin(a), 0.0), Vector3d::UnitZ();
  std::ostringstream out;
  write_geometry(geometry, UffNodes::D2411, out);
  return out.str();
}

// Functions count along the axes of the file that they are in.
TEST_F(TestMesh, NodesOfTheFrfsKeepTheAxesOfTheirFile) {
  folder_.write("mesh.uff", turned_node(9, 0.0));
  folder_.write("measured.uff", turned_node(9, 30.0));
  document_["geometry"] = {{"file", "mesh.uff"}};
  document_.erase("runs");
  document_["frfs"] = "measured.uff";
  for (const double of_mesh : {0.0, 20.0}) {
    folder_.write("mesh.uff", turned_node(9, of_mesh));
    const TestBundle bundle = read_now();
    const TestPoint* point = find_point(bundle.points, 9);
    ASSERT_NE(point, nullptr);
    const Vector3d along(std::sqrt(0.75), 0.5, 0.0);
    EXPECT_TRUE(point->axes.col(0).isApprox(along, 1e-5)) << of_mesh;
  }
}

// Labels from 100000001 on are points of the test's own, as tapfit writes them.
TEST_F(TestMesh, PointsThatTapfitWroteComeBack) {
  folder_.write("measured.uff", turned_node(100'000'009, 30.0));
  document_["geometry"] = json::object();
  document_.erase("runs");
  document_["frfs"] = "measured.uff";
  const TestBundle bundle = read_now();
  const TestPoint* point = find_point(bundle.points, 9);
  ASSERT_NE(point, nullptr);
  EXPECT_EQ(point->of_node, 9);
  const Vector3d along(std::sqrt(0.75), 0.5, 0.0);
  EXPECT_TRUE(point->axes.col(0).isApprox(along, 1e-5));
  folder_.write("measured.uff",
                turned_node(100'000'009, 30.0) + turned_node(9, 0.0));
  refuses_geometry("measured.uff", "nodes 9 and 100000009 are both point 9");
}

TEST_F(TestMesh, LabelsThatAreNoneAreRefused) {
  document_["geometry"] = {{"file", "mesh.uff"}};
  for (const int label : {0, -3}) {
    folder_.write("mesh.uff", turned_node(label, 0.0));
    refuses_geometry("mesh.uff", "no label of a point");
  }
  document_["geometry"] = {{"file", "mesh.csv"}};
  for (const char* label : {"0", "1.5", "100000001", "1e300"}) {
    folder_.write("mesh.csv",
                  fmt::format("label,x,y,z\n{},0,0,0\n1,1,0,0\n", label));
    refuses_geometry("mesh.csv", "no label of a point");
  }
}

TEST_F(TestMesh, PointsAndPairsThatAreNotThereAreRefused) {
  document_["runs"][0]["hammer"]["node"] = 4;
  refuses_geometry("test.json: runs[0].hammer", "no point 4");
  document_["runs"][0]["hammer"]["node"] = 3;
  document_["geometry"]["pairs"][2] = {5, 103};
  refuses_geometry("test.json: geometry.pairs[2]", "no point 5");
  document_["geometry"]["pairs"][2] = {2, 103};
  refuses_geometry("test.json: geometry.pairs[2]", "already");
  document_["geometry"]["pairs"][2] = {3, "x"};
  refuses_geometry("test.json: geometry.pairs[2]", "no pair");
  document_["geometry"]["file"] = "none.csv";
  refuses_geometry("test.json: geometry.file", "no file");
}

}  // namespace
}  // namespace tapfit::acquisition
