// Patches a layer longer and shorter, on meshes that lie anyhow in space.
#include "updating/places/stretched_patches.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;
using Patch = std::vector<int>;

// Shell 1 + i + 6 j covers the square (i, j) of a 6 x 4 plate, turned.
Deck plate(const Eigen::Matrix3d& turn, double skew = 0.0) {
  Deck deck;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 6; ++i) {
      const Vector3d at(i + skew * j, j, 0.0);
      deck.grids.push_back({1 + i + 7 * j, turn * at});
    }
  }
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 6; ++i) {
      const int g = 1 + i + 7 * j;
      deck.shells.push_back({1 + i + 6 * j, 1, {g, g + 1, g + 8, g + 7}});
    }
  }
  return deck;
}

bool has(const std::vector<Patch>& all, const Patch& one) {
  return std::ranges::find(all, one) != all.end();
}

// Elements 8 9 14 15 in the middle: a column or a row more or less on each of
// four sides, and nothing across the plate.
TEST(StretchedPatches, AreALayerLongerOrShorterOnEachSide) {
  const Eigen::Matrix3d turns[] = {
      Eigen::Matrix3d::Identity(),
      Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -1.0).normalized())
          .toRotationMatrix()};
  for (const Eigen::Matrix3d& turn : turns) {
    const auto all = stretched_patches({8, 9, 14, 15}, plate(turn));
    EXPECT_EQ(all.size(), 8U);
    EXPECT_TRUE(has(all, {8, 9, 10, 14, 15, 16}));
    EXPECT_TRUE(has(all, {7, 8, 9, 13, 14, 15}));
    EXPECT_TRUE(has(all, {8, 9, 14, 15, 20, 21}));
    EXPECT_TRUE(has(all, {2, 3, 8, 9, 14, 15}));
    EXPECT_TRUE(has(all, {8, 14}));
    EXPECT_TRUE(has(all, {9, 15}));
    EXPECT_TRUE(has(all, {8, 9}));
    EXPECT_TRUE(has(all, {14, 15}));
  }
}

TEST(StretchedPatches, LayersBesideAreWhatLongerOnesHaveMore) {
  const Patch patch = {8, 9, 14, 15};
  const auto layers = layers_beside(patch, plate(Eigen::Matrix3d::Identity()));
  EXPECT_EQ(layers, (std::vector<Patch>{{10, 16}, {7, 13}, {20, 21}, {2, 3}}));
  // In the corner there are two sides to grow to.
  EXPECT_EQ(layers_beside({1}, plate(Eigen::Matrix3d::Identity())),
            (std::vector<Patch>{{2}, {7}}));
}

TEST(StretchedPatches, InnerOnesLackTheOutermostLayers) {
  const Deck deck = plate(Eigen::Matrix3d::Identity());
  // Rows 2 to 4 of columns 2 to 5: at the edge of the plate nothing is taken.
  EXPECT_EQ(inner_patch({8, 9, 10, 11, 14, 15, 16, 17, 20, 21, 22, 23}, deck),
            (Patch{15, 16, 21, 22}));
  EXPECT_EQ(inner_patch({1, 2, 3}, deck), (Patch{1, 2}));
  EXPECT_EQ(inner_patch({8}, deck), (Patch{8}));
}

// One element can only grow, and at an edge to three sides only.
TEST(StretchedPatches, EndWhereThePlateEnds) {
  const auto all = stretched_patches({2}, plate(Eigen::Matrix3d::Identity()));
  EXPECT_EQ(all.size(), 3U);
  EXPECT_TRUE(has(all, {1, 2}));
  EXPECT_TRUE(has(all, {2, 3}));
  EXPECT_TRUE(has(all, {2, 8}));
}

TEST(StretchedPatches, HoldNoMoreThanHalfOfAll) {
  Patch half;
  for (int id = 1; id <= 12; ++id) half.push_back(id);
  const auto all = stretched_patches(half, plate(Eigen::Matrix3d::Identity()));
  for (const Patch& patch : all) EXPECT_LE(patch.size(), 12U);
}

// Any box is reached from any other, also where columns lean.
TEST(StretchedPatches, LeadToEveryBox) {
  for (const double skew : {0.0, 0.2}) {
    const Deck deck = plate(Eigen::Matrix3d::Identity(), skew);
    Patch at = {8, 9, 14, 15};
    for (const Patch& next :
         {Patch{8, 9, 10, 14, 15, 16}, Patch{8, 9, 10}, Patch{8, 9, 10, 11}}) {
      ASSERT_TRUE(has(stretched_patches(at, deck), next)) << skew;
      at = next;
    }
  }
}

// Bars in line, oblique in space: one more or less at either end.
TEST(StretchedPatches, FollowBarsInLine) {
  Deck deck;
  const Vector3d along = Vector3d(1.0, -2.0, 0.5).normalized();
  for (int k = 0; k <= 8; ++k) deck.grids.push_back({k + 1, along * k});
  for (int k = 1; k <= 8; ++k) {
    structure::Bar bar;
    bar.id = k;
    bar.property = 1;
    bar.grids = {k, k + 1};
    deck.bars.push_back(bar);
  }
  const auto all = stretched_patches({3, 4}, deck);
  EXPECT_EQ(all.size(), 4U);
  for (const Patch& patch :
       {Patch{3}, Patch{4}, Patch{2, 3, 4}, Patch{3, 4, 5}})
    EXPECT_TRUE(has(all, patch));
}

}  // namespace
}  // namespace tapfit::updating
