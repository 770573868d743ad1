// Points without a model: what test.json says of them, and no more.
#include "updating/export/point_geometry.hpp"

#include "acquisition/uff/uff_systems.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

TEST(PointGeometry, LeavesOutWhatOnlyAModelPlaces) {
  const testing::TemporaryFolder folder;
  folder.write("run.wav", "");
  folder.write("test.json", R"({
    "tapfit": 1,
    "channels": [
      {"name": "hammer", "quantity": "force", "unit": "N",
       "sensitivity": 1, "full_scale_volts": 5},
      {"name": "a", "quantity": "acceleration", "unit": "m/s^2",
       "sensitivity": 1, "full_scale_volts": 5},
      {"name": "b", "quantity": "acceleration", "unit": "m/s^2",
       "sensitivity": 1, "full_scale_volts": 5}],
    "runs": [{"file": "run.wav",
      "hammer": {"channel": "hammer",
        "point": {"at": [0.1, 0.2, 0.3], "direction": [0.6, 0, 0.8]}},
      "sensors": [
        {"channel": "a", "point": {"node": 7, "direction": [0.6, 0, 0.8]}},
        {"channel": "b", "point": {"at": [0.4, 0, 0],
          "direction": {"system": 3, "axis": "+X"}}}]}]})");
  Session session(folder.path());
  const acquisition::UffGeometry geometry = point_geometry(session);
  ASSERT_EQ(geometry.nodes.size(), 1U);
  const int label = acquisition::uff_label(-1);
  ASSERT_TRUE(geometry.nodes.contains(label));
  EXPECT_TRUE(
      geometry.nodes.at(label).isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
  const Eigen::Vector3d along(0.6, 0.0, 0.8);
  EXPECT_TRUE(
      acquisition::directions_at(geometry, label).col(2).isApprox(along, 1e-9));
  const std::vector<std::string>& said = session.bundle().warnings;
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("no model says where 2 of the test's points lie (P2"),
            std::string::npos)
      << said[0];
}

}  // namespace
}  // namespace tapfit::updating
