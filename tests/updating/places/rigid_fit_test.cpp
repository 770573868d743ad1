#include "updating/places/rigid_fit.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -0.5).normalized())
                          .toRotationMatrix();
const Vector3d move(0.4, -2.0, 1.0);

TEST(RigidFit, PairsGiveRotationAndTranslation) {
  Matrix3Xd from(3, 4);
  from << 0, 1, 0, 0.3, 0, 0, 2, 0.4, 0, 0, 0, 1.5;
  const Matrix3Xd to = (turn * from).colwise() + move;
  const RigidFit fit = fit_pairs(from, to);
  EXPECT_TRUE(fit.rotation.isApprox(turn, 1e-12));
  EXPECT_TRUE(fit.translation.isApprox(move, 1e-12));
  EXPECT_NEAR(fit.rms, 0.0, 1e-12);
  EXPECT_NEAR(fit.scale, 1.0, 1e-12);
  EXPECT_TRUE(fit.determined);
  // Three in a plane are enough, whatever their mirror image.
  const RigidFit flat = fit_pairs(from.leftCols(3), to.leftCols(3));
  EXPECT_TRUE(flat.rotation.isApprox(turn, 1e-12));
  EXPECT_NEAR(fit_pairs(from, 25.4 * to).scale, 25.4, 1e-9);
}

TEST(RigidFit, PairsOnALineLeaveATurnOpen) {
  Matrix3Xd line(3, 3);
  line << 0, 1, 3, 0, 1, 3, 0, 0, 0;
  EXPECT_FALSE(fit_pairs(line, line).determined);
  EXPECT_FALSE(fit_pairs(line.leftCols(2), line.leftCols(2)).determined);
}

// A plate with a fin, which fits in one way alone.
structure::Deck finned() {
  structure::Deck deck = support::plate_deck(false);
  deck.grids.push_back({101, {0.06, 0.03, 0.05}});
  deck.grids.push_back({102, {0.09, 0.03, 0.05}});
  deck.shells.push_back({101, 1, {14, 15, 102, 101}});
  return deck;
}

TEST(RigidFit, AMeshFindsTheModelByItself) {
  const structure::Deck deck = finned();
  const MeshSurface surface(deck);
  std::vector<Vector3d> measured;
  for (const structure::Grid& grid : deck.grids) {
    if (grid.id % 3 == 0 || grid.id > 100) measured.push_back(grid.position);
  }
  Matrix3Xd points(3, static_cast<Eigen::Index>(measured.size()));
  for (std::size_t k = 0; k < measured.size(); ++k) {
    points.col(static_cast<Eigen::Index>(k)) =
        turn.transpose() * (measured[k] - move);
  }
  const std::vector<RigidFit> ways = fit_to_mesh(points, deck, surface);
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_LT(ways[0].rms, 1e-4);
  for (std::size_t k = 0; k < measured.size(); ++k) {
    EXPECT_LT((ways[0] * points.col(static_cast<Eigen::Index>(k)) - measured[k])
                  .norm(),
              1e-3);
  }
}

TEST(RigidFit, ASymmetricModelIsFittedInSeveralWays) {
  const structure::Deck deck = support::plate_deck(false);
  Matrix3Xd points(3, 6);
  points << 0, 0.3, 0.3, 0, 0.15, 0.06, 0, 0, 0.12, 0.12, 0.06, 0.03, 1, 1, 1,
      1, 1, 1;
  EXPECT_GT(fit_to_mesh(points, deck, MeshSurface(deck)).size(), 1U);
  EXPECT_FALSE(as_they_are(points, MeshSurface(deck)).has_value());
  // In the model's own axes there is nothing to find.
  points.row(2).setZero();
  const auto same = as_they_are(points, MeshSurface(deck));
  ASSERT_TRUE(same.has_value());
  EXPECT_TRUE(same->rotation.isIdentity(0.0));
}

}  // namespace
}  // namespace tapfit::updating
