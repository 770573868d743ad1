#include "updating/places/between_grids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;

structure::Deck deck_of(const std::vector<Vector3d>& corners,
                        const std::vector<std::vector<int>>& shells) {
  structure::Deck deck;
  int id = 1;
  for (const Vector3d& x : corners) deck.grids.push_back({id++, x});
  id = 1;
  for (const std::vector<int>& grids : shells) {
    deck.shells.push_back({id++, 1, grids});
  }
  return deck;
}

// A motion w(x, y) across the plane z = 0, with the rotations that go with it.
struct Bending {
  std::function<double(double, double)> w;
  std::function<double(double, double)> wx;
  std::function<double(double, double)> wy;

  [[nodiscard]] double at(const structure::Deck& deck,
                          const MotionShare& share) const {
    const Vector3d x = deck.grid(share.node).position;
    if (share.component == 3) return w(x.x(), x.y());
    if (share.component == 4) return wy(x.x(), x.y());
    if (share.component == 5) return -wx(x.x(), x.y());
    return 0.0;
  }
  [[nodiscard]] double between(const structure::Deck& deck,
                               const Location& where) const {
    double sum = 0.0;
    for (const MotionShare& share : motion_between(deck, where, 3)) {
      sum += share.weight * at(deck, share);
    }
    return sum;
  }
};

Location place(int node, double x, double y, double z = 0.0) {
  Location where;
  where.node = node;
  where.at = {x, y, z};
  return where;
}

const Bending curved = {
    [](double x, double y) { return 1.0 + x - 2.0 * y + x * x + 3.0 * x * y; },
    [](double x, double y) { return 1.0 + 2.0 * x + 3.0 * y; },
    [](double x, double) { return -2.0 + 3.0 * x; }};

TEST(BetweenGrids, AQuadrilateralThatIsBentIsFollowed) {
  const structure::Deck deck =
      deck_of({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{1, 2, 3, 4}});
  for (const double x : {0.0, 0.3, 1.0, 1.7}) {
    for (const double y : {0.0, 0.25, 0.9}) {
      EXPECT_NEAR(curved.between(deck, place(1, x, y)), curved.w(x, y), 1e-12);
    }
  }
}

TEST(BetweenGrids, ATriangleThatIsBentIsFollowed) {
  const structure::Deck deck =
      deck_of({{0, 0, 0}, {2, 0.3, 0}, {0.4, 1.5, 0}}, {{1, 2, 3}});
  for (const double a : {0.1, 0.4}) {
    for (const double b : {0.05, 0.3, 0.5}) {
      const double x = 2.0 * a + 0.4 * b;
      const double y = 0.3 * a + 1.5 * b;
      EXPECT_NEAR(curved.between(deck, place(2, x, y)), curved.w(x, y), 1e-12);
    }
  }
}

TEST(BetweenGrids, ABarThatIsBentIsFollowedToTheThirdOrder) {
  structure::Deck deck;
  deck.grids = {{1, {0, 0, 0}}, {2, {2, 0, 0}}};
  structure::Bar bar;
  bar.id = 1;
  bar.grids = {1, 2};
  deck.bars = {bar};
  const Bending cubic = {[](double x, double) { return x * x * x - x; },
                         [](double x, double) { return 3.0 * x * x - 1.0; },
                         [](double, double) { return 0.0; }};
  for (const double x : {0.0, 0.5, 1.3, 2.0}) {
    EXPECT_NEAR(cubic.between(deck, place(2, x, 0.0)), cubic.w(x, 0.0), 1e-12);
  }
}

TEST(BetweenGrids, PlacesAroundLieOnElementsAndNameTheNearestGrid) {
  const structure::Deck deck =
      deck_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 2, 3, 4}});
  Location corner;
  corner.node = 1;
  const std::vector<Location> around = places_around(corner, 0.5, deck);
  ASSERT_EQ(around.size(), 2U);
  for (const Location& where : around) {
    EXPECT_NEAR(position_of(where, deck).norm(), 0.5, 1e-12);
  }
  const std::vector<Location> moved = moved_to(corner, {0.8, 0.3, 0.0}, deck);
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].node, 2);
  EXPECT_TRUE(moved_to(corner, {0.8, 1.3, 0.0}, deck).empty());
  EXPECT_TRUE(moved_to(corner, {0.8, 0.3, 0.2}, deck).empty());
}

// Along the plane there is no bending: shares are those of the corners.
TEST(BetweenGrids, MotionAlongThePlaneIsLinear) {
  const structure::Deck deck =
      deck_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 2, 3, 4}});
  double sum = 0.0;
  for (const MotionShare& share :
       motion_between(deck, place(1, 0.25, 0.5), 1)) {
    EXPECT_EQ(share.component, 1);
    sum += share.weight * deck.grid(share.node).position.x();
  }
  EXPECT_NEAR(sum, 0.25, 1e-12);
}

}  // namespace
}  // namespace tapfit::updating
