// The test's mesh laid over the model where no pairs are named.
#include "updating/measurement/lay_over.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/sample_plate.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <string>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;

// Some of the plate's grids, turned, moved and in another unit.
acquisition::TestGeometry mesh_of(const structure::Deck& deck, double scale) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.6, Vector3d(1, -2, 0.4).normalized())
          .toRotationMatrix();
  acquisition::TestGeometry geometry;
  geometry.file = "mesh.csv";
  int label = 500;
  for (std::size_t k = 0; k < deck.grids.size(); k += 5) {
    geometry.nodes[++label] =
        scale * (turn * deck.grids[k].position + Vector3d(0.3, 0.1, 2.0));
  }
  return geometry;
}

std::string refusal_of_mesh(double scale) {
  const structure::Deck deck = support::plate_deck(false);
  const acquisition::TestGeometry geometry = mesh_of(deck, scale);
  std::set<int> used;
  for (const auto& [label, at] : geometry.nodes) used.insert(label);
  try {
    (void)lay_over(geometry, used, deck, MeshSurface(deck));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(LayOver, AMeshInAnotherUnitIsSaidToBe) {
  for (const double scale : {1000.0, 100.0, 39.37}) {
    const std::string text = refusal_of_mesh(scale);
    EXPECT_NE(text.find("times as far"), std::string::npos) << text;
    EXPECT_NE(text.find("unit of the test's coordinates"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("ways"), std::string::npos) << text;
  }
}

TEST(LayOver, AMeshThatFitsInSeveralWaysIsComparedInSize) {
  const std::string small = refusal_of_mesh(1e-3);
  EXPECT_NE(small.find("check the unit"), std::string::npos) << small;
  const std::string own = refusal_of_mesh(1.0);
  EXPECT_EQ(own.find("unit"), std::string::npos) << own;
}

}  // namespace
}  // namespace tapfit::updating
