#include "updating/places/clamp_places.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Places = std::vector<std::vector<int>>;

bool tries(const Places& places, const std::vector<int>& nodes) {
  return std::ranges::count(places, nodes) == 1;
}

TEST(ClampPlaces, OfAPlateAreItsEdgesAndCorners) {
  const Places places = clamp_places(support::plate_deck(false));
  EXPECT_TRUE(tries(places, {1, 12, 23, 34, 45}));
  EXPECT_TRUE(tries(places, {11, 22, 33, 44, 55}));
  EXPECT_TRUE(tries(places, {1, 11, 12, 22, 23, 33, 34, 44, 45, 55}));
  EXPECT_TRUE(tries(places, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_TRUE(tries(places, {1, 11, 45, 55}));
  EXPECT_TRUE(tries(places, {1, 45}));
  // Four edges, two pairs that face each other, the corners of each edge and
  // all of them.
  EXPECT_EQ(places.size(), 11U);
}

TEST(ClampPlaces, HoldNothingThatTheDeckHolds) {
  const Places places = clamp_places(support::plate_deck(true));
  ASSERT_FALSE(places.empty());
  for (const std::vector<int>& nodes : places) {
    for (const int node : nodes) EXPECT_NE(node % 11, 1) << node;
  }
  EXPECT_TRUE(tries(places, {11, 22, 33, 44, 55}));
  EXPECT_TRUE(tries(places, {2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
}

// A frame of bars: two feet, a beam across.
TEST(ClampPlaces, OfAFrameAreItsFeetTogetherAndEach) {
  structure::Deck deck;
  deck.grids = {{1, {0, 0, 0}},
                {2, {0, 0, 1}},
                {3, {1, 0, 1}},
                {4, {1, 0, 0}},
                {5, {0.5, 0, 1}}};
  deck.bars = {structure::make_bar(1, 1, 1, 2),
               structure::make_bar(2, 1, 2, 5),
               structure::make_bar(3, 1, 5, 3),
               structure::make_bar(4, 1, 3, 4)};
  const Places places = clamp_places(deck);
  EXPECT_TRUE(tries(places, {1, 4}));
  EXPECT_TRUE(tries(places, {1}));
  EXPECT_TRUE(tries(places, {4}));
  EXPECT_TRUE(tries(places, {1, 2}));  // a leg, on its side
  for (const std::vector<int>& nodes : places) EXPECT_LE(nodes.size(), 2U);
}

// A ring of eight shells: its hole has no corners.
TEST(ClampPlaces, AroundAHoleAreOne) {
  structure::Deck deck;
  std::vector<int> hole;
  for (int k = 0; k < 8; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / 4.0;
    const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0.0);
    deck.grids.push_back({1 + k, along});
    deck.grids.push_back({11 + k, 2.0 * along});
    const int next = (k + 1) % 8;
    deck.shells.push_back({1 + k, 1, {1 + k, 11 + k, 11 + next, 1 + next}});
    hole.push_back(1 + k);
  }
  EXPECT_TRUE(tries(clamp_places(deck), hole));
}

}  // namespace
}  // namespace tapfit::updating
