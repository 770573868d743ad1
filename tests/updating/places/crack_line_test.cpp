#include "updating/places/crack_line.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

// Eleven grids along x, five along y, all 0.03 m apart: 6, 17, 28, 39, 50 is a
// line across.
class CrackLineTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<int> parted(const std::vector<int>& nodes) const {
    std::vector<int> ids;
    for (const PartedGrid& grid : crack_line(deck_, nodes).grids) {
      ids.push_back(grid.node);
    }
    return ids;
  }

  structure::Deck deck_ = support::plate_deck(false);
};

TEST_F(CrackLineTest, OpensAtAFreeEdgeAndEndsInItsTip) {
  EXPECT_EQ(parted({6, 17, 28}), (std::vector<int>{6, 17}));
  EXPECT_EQ(parted({17, 28, 39}), std::vector<int>{28});
  EXPECT_EQ(parted({6, 17, 28, 39, 50}), (std::vector<int>{6, 17, 28, 39, 50}));
  // Two tips, and nothing between them.
  EXPECT_TRUE(parted({17, 28}).empty());
  EXPECT_TRUE(parted({6}).empty());
  // By the ends of the line; not askew to it.
  EXPECT_TRUE(parted({6, 28}).size() == 2U);
  EXPECT_TRUE(parted({6, 19}).empty());
}

// The face of the elements on one side, from the edge to half way between the
// last grid that parts and the tip.
TEST_F(CrackLineTest, HoldsThicknessTimesLength) {
  const double t = deck_.shell_properties.begin()->second.thickness;
  const CrackLine crack = crack_line(deck_, {6, 17, 28});
  ASSERT_EQ(crack.grids.size(), 2U);
  EXPECT_NEAR(crack.grids[0].area, 0.015 * t, 1e-12);
  EXPECT_NEAR(crack.grids[1].area, 0.030 * t, 1e-12);
  EXPECT_NEAR(crack.grids[1].turn, 0.030 * t * t * t / 12.0, 1e-15);
  EXPECT_NEAR(std::abs(crack.grids[1].axes[0].y()), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(crack.grids[1].axes[1].x()), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(crack.grids[1].axes[2].z()), 1.0, 1e-12);
}

// Not round the tip to the other side.
TEST_F(CrackLineTest, TakesElementsOfOneSideAlone) {
  const CrackLine crack = crack_line(deck_, {6, 17, 28});
  ASSERT_EQ(crack.side.size(), 2U);
  std::set<double> sides;
  for (const structure::Shell& shell : deck_.shells) {
    if (std::ranges::find(crack.side, shell.id) == crack.side.end()) continue;
    double x = 0.0;
    for (const int id : shell.grids) {
      x += 0.25 * deck_.grid(id).position.x();
    }
    sides.insert(x > 0.15 ? 1.0 : -1.0);
  }
  EXPECT_EQ(sides.size(), 1U);
}

// Two elements beside each other: the lines along both, and those across.
TEST_F(CrackLineTest, RunsThroughAPatch) {
  std::vector<int> patch;
  for (const structure::Shell& shell : deck_.shells) {
    const bool inside = std::ranges::all_of(shell.grids, [](int id) {
      return id == 16 || id == 17 || id == 27 || id == 28 || id == 38 ||
             id == 39;
    });
    if (inside) patch.push_back(shell.id);
  }
  ASSERT_EQ(patch.size(), 2U);
  std::set<std::set<int>> cracks;
  for (const auto& nodes : cracks_within(deck_, patch)) {
    cracks.insert({nodes.begin(), nodes.end()});
  }
  EXPECT_EQ(cracks,
            (std::set<std::set<int>>{
                {16, 27, 38}, {17, 28, 39}, {16, 17}, {27, 28}, {38, 39}}));
}

TEST_F(CrackLineTest, MayEndOneGridOnOrBefore) {
  const auto near = cracks_near(deck_, {6, 17, 28});
  const std::set<std::vector<int>> all(near.begin(), near.end());
  EXPECT_EQ(all,
            (std::set<std::vector<int>>{{6, 17}, {17, 28}, {6, 17, 28, 39}}));
}

}  // namespace
}  // namespace tapfit::updating
