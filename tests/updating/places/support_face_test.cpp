#include "updating/places/support_face.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/places/support_line.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;

// Springs under an area in three directions, summed over its points: u + theta
// x r. The middle rule over n x n cells of a rectangle with the sides a and b.
GridMatrix summed(const Vector3d& centre,
                  const Vector3d& a,
                  const Vector3d& b,
                  int n) {
  GridMatrix S = GridMatrix::Zero();
  const double cell = a.norm() * b.norm() / (n * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vector3d r =
          centre + ((i + 0.5) / n - 0.5) * a + ((j + 0.5) / n - 0.5) * b;
      Eigen::Matrix<double, 3, 6> moves = Eigen::Matrix<double, 3, 6>::Zero();
      moves.leftCols<3>().setIdentity();
      for (int c = 0; c < 3; ++c) {
        moves.col(3 + c) = Vector3d::Unit(c).cross(r);
      }
      S += cell * moves.transpose() * moves;
    }
  }
  return S;
}

// 30 x 8 mm, 5 mm above its grid, askew to the axes.
TEST(SupportFace, SectionOfABarIsABedOfSprings) {
  const structure::Deck deck = structure::deck_of(
      "MAT1,1,7.+10,,.3,2700.\n"
      "PBAR,1,1,2.4-4,1.28-9,1.8-8,4.2-9\n"
      "GRID,1,,0.,0.,0.\nGRID,2,,.4,0.,0.\n"
      "CBAR,1,1,1,2,0.,.6,.8\n,,,0.,0.,.005,0.,0.,.005\nSPC1,1,123456,1\n");
  const Vector3d thick(0.0, 0.6, 0.8);  // plane 1: I1 about the other
  const Vector3d wide(0.0, -0.8, 0.6);
  const GridMatrix exact =
      summed({0.0, 0.0, 0.005}, 0.008 * thick, 0.030 * wide, 200);
  const auto face = support_face(deck, {1});
  ASSERT_EQ(face.size(), 1U);
  // The middle rule is short by 1 / n^2 of a second moment.
  EXPECT_LT((face.at(1) - exact).norm(), 1e-4 * exact.norm());
  EXPECT_LT((face.at(1) - exact).bottomRightCorner(3, 3).norm(),
            1e-4 * exact.bottomRightCorner(3, 3).norm());
}

// Each grid has half of the edges beside it; nothing turns about the normal.
TEST(SupportFace, EdgeOfAPlateIsItsThicknessTimesItsLength) {
  structure::Deck deck = support::plate_deck(false);
  const std::vector<int> nodes = {1, 12, 23, 34, 45};
  for (const int node : nodes) deck.constraints.push_back({node, "123456"});
  const double t = deck.shell_properties.begin()->second.thickness;
  const auto face = support_face(deck, nodes);
  ASSERT_EQ(face.size(), 5U);
  Vector3d areas = Vector3d::Zero();
  Vector3d turns = Vector3d::Zero();
  for (const auto& [node, S] : face) {
    areas += S.diagonal().head<3>();
    turns += S.diagonal().tail<3>();
  }
  const double inertia = 0.12 * t * t * t / 12.0;
  for (const int c : {0, 1, 2}) EXPECT_NEAR(areas(c), 0.12 * t, 1e-12);
  EXPECT_NEAR(turns(0), inertia, 1e-12 * inertia);
  EXPECT_NEAR(turns(1), inertia, 1e-12 * inertia);
  EXPECT_NEAR(turns(2), 0.0, 1e-12 * inertia);
  EXPECT_NEAR(face.at(1)(0, 0), 0.5 * face.at(12)(0, 0), 1e-12);
}

// A strip that is clamped over its length has its face inside.
TEST(SupportFace, ElementHeldWhollyHasNone) {
  structure::Deck deck = support::plate_deck(false);
  EXPECT_TRUE(support_face(deck, {1, 2, 12, 13}).empty());
}

// The face of what is pinned turns freely.
TEST(SupportFace, IsAFormOfClampsAlone) {
  const std::vector<int> nodes = {1, 12, 23, 34, 45};
  structure::Deck deck = support::plate_deck(false);
  for (const int node : nodes) deck.constraints.push_back({node, "123456"});
  const std::vector<SupportPart> parts = support_parts(deck, nodes, "face");
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts.front().motion, SupportMotion::Face);
  // Three translations and two turns of each.
  EXPECT_EQ(parts.front().line.dofs.size(), 25U);
  const double t = deck.shell_properties.begin()->second.thickness;
  EXPECT_NEAR(parts.front().turn, 0.01 * t * t * t, 1e-12 * t * t * t);
  EXPECT_NEAR(parts.front().line.length, 0.12, 1e-12);
  structure::Deck pinned = support::plate_deck(false);
  for (const int node : nodes) pinned.constraints.push_back({node, "123"});
  EXPECT_TRUE(support_parts(pinned, nodes, "face").empty());
}

}  // namespace
}  // namespace tapfit::updating
