#include "updating/places/point_on_mesh.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

Deck deck_at(const std::vector<Vector3d>& corners) {
  Deck deck;
  int id = 1;
  for (const Vector3d& x : corners) deck.grids.push_back({id++, x});
  return deck;
}

Deck plate() {
  Deck deck =
      deck_at({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1.2, 0}, {3.5, 0.3, 0}});
  deck.shells = {{1, 1, {1, 2, 3, 4}}, {2, 1, {2, 5, 3}}};
  return deck;
}

Deck beam(bool rod) {
  Deck deck = deck_at({{0, 0, 0}, {2, 1, 0.5}});
  structure::Bar bar;
  bar.id = 7;
  bar.grids = {1, 2};
  if (rod) {
    deck.rods = {{7, 1, {1, 2}}};
  } else {
    deck.bars = {bar};
  }
  return deck;
}

// A hexahedron and a tetrahedron on its top, with or without mids.
Deck block(bool quadratic) {
  Deck deck = deck_at({{0, 0, 0},
                       {1, 0, 0},
                       {1, 1, 0},
                       {0, 1, 0},
                       {0, 0, 1},
                       {1, 0, 1},
                       {1, 1, 1.2},
                       {0, 1, 1}});
  structure::Solid solid;
  solid.id = 3;
  solid.grids = {1, 2, 3, 4, 5, 6, 7, 8};
  if (quadratic) {
    const std::vector<std::array<int, 2>> edges = {{1, 2},
                                                   {2, 3},
                                                   {3, 4},
                                                   {4, 1},
                                                   {1, 5},
                                                   {2, 6},
                                                   {3, 7},
                                                   {4, 8},
                                                   {5, 6},
                                                   {6, 7},
                                                   {7, 8},
                                                   {8, 5}};
    int id = 9;
    for (const auto& [a, b] : edges) {
      const Vector3d mid =
          0.5 * (deck.grid(a).position + deck.grid(b).position);
      deck.grids.push_back({id, mid});
      solid.mids.push_back(id++);
    }
  }
  deck.solids = {solid};
  return deck;
}

// A field of motion, and of turning where grids turn.
struct Field {
  std::function<Vector3d(const Vector3d&)> u;
  std::function<Vector3d(const Vector3d&)> turn;

  [[nodiscard]] double sum(const Deck& deck,
                           const std::vector<MotionShare>& shares) const {
    double total = 0.0;
    for (const MotionShare& share : shares) {
      const Vector3d x = deck.grid(share.node).position;
      const int axis = (share.component - 1) % 3;
      total +=
          share.weight * (share.component > 3 ? turn(x)(axis) : u(x)(axis));
    }
    return total;
  }
};

Field rigid(const Vector3d& move, const Vector3d& turn) {
  return {[=](const Vector3d& x) { return Vector3d(move + turn.cross(x)); },
          [=](const Vector3d&) { return turn; }};
}

// Whatever carries a point and however far away it is: it moves with a body
// that moves as one, and turns with it.
void follows_rigid_bodies(const Deck& deck,
                          const Vector3d& at,
                          const Vector3d& turn) {
  const MeshSurface surface(deck);
  const auto point = surface.nearest(at);
  ASSERT_TRUE(point.has_value());
  const Field field = rigid({0.3, -0.2, 0.5}, turn);
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0.6, 0.48, 0.64)}) {
    EXPECT_NEAR(field.sum(deck, motion_at(*point, deck, at, axis)),
                field.u(at).dot(axis),
                1e-12)
        << describe(point->part);
    EXPECT_NEAR(
        field.sum(deck, turning_at(*point, deck, axis)), turn.dot(axis), 1e-12)
        << describe(point->part);
  }
}

TEST(PointOnMesh, MovesWithABodyThatMovesAsOne) {
  const Vector3d turn(0.2, -0.4, 0.7);
  for (const Vector3d& at : {Vector3d(0.7, 0.4, 0.0),
                             Vector3d(1.9, 0.8, 0.3),
                             Vector3d(2.5, 0.3, -0.2),
                             Vector3d(-0.2, 0.5, 0.1),
                             Vector3d(2.0, 1.0, 0.0)}) {
    follows_rigid_bodies(plate(), at, turn);
  }
  follows_rigid_bodies(beam(false), {0.9, 0.6, 0.1}, turn);
  for (const bool quadratic : {false, true}) {
    for (const Vector3d& at : {Vector3d(0.3, 0.6, 1.1),
                               Vector3d(1.2, 0.4, 0.7),
                               Vector3d(0.4, 0.3, 0.0),
                               Vector3d(-0.1, 0.5, 0.5),
                               Vector3d(1.0, 0.0, 1.0)}) {
      follows_rigid_bodies(block(quadratic), at, turn);
    }
  }
  // A rod says nothing of a turn about itself.
  const Vector3d along = Vector3d(2, 1, 0.5).normalized();
  follows_rigid_bodies(
      beam(true), {0.9, 0.6, 0.1}, turn - turn.dot(along) * along);
}

// A sensor at height h on a plate bent to w(x): u = -h w'(x) along the plate.
TEST(PointOnMesh, ASensorAboveABentPlateMovesAlongIt) {
  const Deck deck = plate();
  const Field bent{[](const Vector3d& x) {
                     return Vector3d(0.0, 0.0, x.x() * x.x() + x.x() * x.y());
                   },
                   [](const Vector3d& x) {
                     return Vector3d(x.x(), -2.0 * x.x() - x.y(), 0.0);
                   }};
  const double h = 0.1;
  const Vector3d foot(0.8, 0.35, 0.0);
  const auto on = MeshSurface(deck).nearest(foot);
  ASSERT_TRUE(on.has_value());
  EXPECT_EQ(describe(on->part), "shell 1");
  EXPECT_TRUE(on->normal.isApprox(Vector3d::UnitZ(), 1e-12));
  const Vector3d at = foot + h * on->normal;
  const auto moved = [&](const Vector3d& axis) {
    return bent.sum(deck, motion_at(*on, deck, at, axis));
  };
  EXPECT_NEAR(moved(Vector3d::UnitX()), -h * (2.0 * 0.8 + 0.35), 1e-12);
  EXPECT_NEAR(moved(Vector3d::UnitY()), -h * 0.8, 1e-12);
  // The quadrilateral is no rectangle, whose shape functions follow a parabola
  // to the last digit only as one.
  EXPECT_NEAR(moved(Vector3d::UnitZ()), 0.8 * 0.8 + 0.8 * 0.35, 2e-2);
}

TEST(PointOnMesh, AQuadraticFaceFollowsAParabola) {
  const Deck deck = block(true);
  const Field field{[](const Vector3d& x) {
                      return Vector3d(
                          x.y() * x.y(), x.x() * x.y(), x.x() * x.x());
                    },
                    {}};
  const Vector3d at(0.3, 0.6, 0.0);
  const auto on = MeshSurface(deck).nearest(at);
  ASSERT_TRUE(on.has_value());
  EXPECT_TRUE(on->normal.isApprox(-Vector3d::UnitZ(), 1e-12));
  for (const Vector3d& axis :
       {Vector3d(Vector3d::UnitX()), Vector3d(0.0, 0.6, 0.8)}) {
    EXPECT_NEAR(field.sum(deck, motion_at(*on, deck, at, axis)),
                field.u(at).dot(axis),
                1e-12);
  }
}

// One component of one grid, but for rounding.
bool is_one(const std::vector<MotionShare>& shares, int grid, int component) {
  double own = 0.0;
  double others = 0.0;
  for (const MotionShare& share : shares) {
    const bool it = share.node == grid && share.component == component;
    (it ? own : others) += std::abs(share.weight);
  }
  return std::abs(own - 1.0) < 1e-12 && others < 1e-12;
}

// A grid in the middle of a side moves and turns as it does itself, be the side
// bulged or hollow.
TEST(PointOnMesh, InTheMiddleOfACurvedSideItIsTheGrid) {
  for (const double bulge : {0.2, -0.2}) {
    Deck deck = deck_at({{0, 0, 0},
                         {2, 0, 0},
                         {0, 2, 0},
                         {1, -bulge, 0},
                         {1 + bulge, 1 + bulge, 0},
                         {0, 1, 0}});
    deck.shells = {{1, 1, {1, 2, 3}}};
    deck.shells[0].mids = {4, 5, 6};
    for (const int grid : {4, 5, 6, 2}) {
      const Vector3d at = deck.grid(grid).position;
      const auto on = MeshSurface(deck).at_grid(grid);
      EXPECT_TRUE(on.normal.isApprox(Vector3d::UnitZ(), 1e-12)) << grid;
      const auto moved = motion_at(on, deck, at, Vector3d::UnitZ());
      const auto turned = turning_at(on, deck, Vector3d::UnitX());
      EXPECT_TRUE(is_one(moved, grid, 3)) << bulge << " grid " << grid;
      EXPECT_TRUE(is_one(turned, grid, 4)) << bulge << " grid " << grid;
    }
  }
}

TEST(PointOnMesh, SaysHowFarAwayItIsAndHowLargeTheElement) {
  const auto on = MeshSurface(plate()).nearest({0.5, 0.5, -0.25});
  ASSERT_TRUE(on.has_value());
  EXPECT_NEAR(on->off, 0.25, 1e-12);
  EXPECT_TRUE(on->foot.isApprox(Vector3d(0.5, 0.5, 0.0), 1e-9));
  EXPECT_NEAR(on->size, (2.0 + 1.0 + std::hypot(2.0, 0.2) + 1.2) / 4.0, 1e-12);
  // Beyond the edge it hangs on that.
  const auto beside = MeshSurface(plate()).nearest({0.5, -0.3, 0.0});
  EXPECT_NEAR(beside->off, 0.3, 1e-12);
  EXPECT_TRUE(beside->foot.isApprox(Vector3d(0.5, 0.0, 0.0), 1e-9));
}

// Grids that no element has, such as the hub of a rigid one.
TEST(PointOnMesh, AGridAwayFromTheElementsCarriesItself) {
  Deck deck = plate();
  deck.grids.push_back({9, {0.5, 0.5, 0.4}});
  const auto on = MeshSurface(deck).nearest({0.5, 0.5, 0.4});
  ASSERT_TRUE(on.has_value());
  EXPECT_EQ(describe(on->part), "grid 9");
  const auto shares =
      motion_at(*on, deck, {0.5, 0.5, 0.4}, Vector3d(0.6, 0.0, 0.8));
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0], (MotionShare{9, 1, 0.6}));
  EXPECT_EQ(shares[1], (MotionShare{9, 3, 0.8}));
}

TEST(PointOnMesh, WhereASurfaceFoldsItHasNoOneNormal) {
  Deck deck = deck_at(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}});
  deck.shells = {{1, 1, {1, 2, 3, 4}}, {2, 1, {2, 5, 6, 3}}};
  EXPECT_TRUE(MeshSurface(deck).at_grid(2).normal.isZero());
  EXPECT_FALSE(MeshSurface(deck).at_grid(1).normal.isZero());
}

}  // namespace
}  // namespace tapfit::updating
