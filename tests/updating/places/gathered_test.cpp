#include "updating/places/gathered.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/places/element_cells.hpp"
#include "updating/places/told_apart.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> raster(int columns, int rows) {
  std::vector<Vector3d> at;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) at.emplace_back(0.1 * c, 0.1 * r, 0.0);
  }
  return at;
}

TEST(Gathered, LeavesFewAlone) {
  const auto groups = gathered(raster(6, 5), 30);
  ASSERT_EQ(groups.size(), 30U);
  for (std::size_t k = 0; k < groups.size(); ++k) {
    EXPECT_EQ(groups[k], std::vector<std::size_t>{k});
  }
}

TEST(Gathered, HoldsEachOnceInGroupsThatLieTogether) {
  const std::vector<Vector3d> at = raster(40, 30);
  const auto groups = gathered(at, 100);
  EXPECT_LE(groups.size(), 100U);
  // Cubes of the next smaller size would be more than asked for.
  EXPECT_GT(groups.size(), 50U);
  std::set<std::size_t> seen;
  for (const auto& group : groups) {
    for (const std::size_t k : group) {
      EXPECT_TRUE(seen.insert(k).second);
      // 1,200 on an area of 12 m^2 in 100 squares at least 0.35 m wide, no
      // wider than twice that.
      EXPECT_LT((at[k] - at[group.front()]).cwiseAbs().maxCoeff(), 0.7);
    }
  }
  EXPECT_EQ(seen.size(), at.size());
}

TEST(Gathered, IsOneGroupWhereAllLieOnOnePoint) {
  const std::vector<Vector3d> same(50, Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(gathered(same, 10).size(), 1U);
  EXPECT_EQ(spread_out(same, 10).size(), 1U);
}

TEST(SpreadOut, TakesOneFromTheMiddleOfEach) {
  const std::vector<Vector3d> at = raster(40, 30);
  const auto kept = spread_out(at, 100);
  ASSERT_EQ(kept.size(), gathered(at, 100).size());
  EXPECT_TRUE(std::ranges::is_sorted(kept));
  // Nothing is far from one that is kept.
  for (const Vector3d& x : at) {
    const std::size_t nearest = std::ranges::min(
        kept, {}, [&](std::size_t k) { return (at[k] - x).norm(); });
    EXPECT_LT((at[nearest] - x).norm(), 0.5);
  }
}

TEST(ElementCells, AreElementsOfACoarseMesh) {
  const structure::Deck deck = support::plate_deck(true);
  const auto cells = element_cells(deck);
  ASSERT_EQ(cells.size(), deck.element_count());
  EXPECT_EQ(cells[2].elements, std::vector<int>{deck.shells[2].id});
}

// 40 shells split four times are 10,240.
TEST(ElementCells, AreAsManyOnAFineMesh) {
  structure::Deck deck = support::plate_deck(true);
  for (int k = 0; k < 4; ++k) deck = structure::refine_mesh(deck).deck;
  ASSERT_EQ(deck.shells.size(), 10240U);
  const auto cells = element_cells(deck);
  EXPECT_LE(cells.size(), most_places);
  EXPECT_GT(cells.size(), most_places / 2);
  std::size_t elements = 0;
  for (const ElementCell& cell : cells) elements += cell.elements.size();
  EXPECT_EQ(elements, deck.shells.size());
}

TEST(ToldApart, KeepsPlacesOfEachForm) {
  structure::Deck deck = support::plate_deck(true);
  for (int k = 0; k < 3; ++k) deck = structure::refine_mesh(deck).deck;
  ASSERT_GT(deck.grids.size(), 2000U);
  std::vector<Location> places;
  for (const char* form : {"", "X"}) {
    for (const structure::Grid& grid : deck.grids) {
      Location where;
      where.node = grid.id;
      where.variant = form;
      places.push_back(where);
    }
  }
  const auto kept = told_apart(places, deck);
  const auto plain =
      std::ranges::count(kept, std::string(), &Location::variant);
  EXPECT_EQ(2 * plain, std::ssize(kept));
  EXPECT_LE(plain, static_cast<std::ptrdiff_t>(most_places));
  EXPECT_GT(plain, static_cast<std::ptrdiff_t>(most_places / 2));
}

}  // namespace
}  // namespace tapfit::updating
