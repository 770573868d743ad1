#include "updating/structure/mesh/member_corners.hpp"

#include "tests/updating/support/corner_decks.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

using namespace corner_decks;

TEST(MemberCorners, KnowWhichMemberGoesOn) {
  const MemberCorners corners = member_corners(meeting(false));
  ASSERT_EQ(corners.ends.size(), 1U);
  const CornerEnd& end = corners.ends[0];
  EXPECT_EQ(end.grid, 2);
  EXPECT_EQ(corners.members[end.own].bar, 2U);
  EXPECT_TRUE(end.in_through);
  EXPECT_EQ(end.meeting, 3U);
  EXPECT_NEAR(end.length, 0.5 * depth, 1e-12);
}

// However fine the mesh, the pieces of an end are as long as the end.
TEST(MemberCorners, WalkOverAFineMesh) {
  Deck deck = two_legs(90.0, 0.0);
  for (int split = 0; split < 3; ++split) {
    const MemberCorners corners = member_corners(deck);
    ASSERT_EQ(corners.ends.size(), 2U);
    for (const CornerEnd& end : corners.ends) {
      double length = 0.0;
      for (const auto& [member, share] : end.inside) {
        length += share * corners.members[member].length;
      }
      EXPECT_NEAR(length, 0.5 * depth, 1e-12) << split;
    }
    deck = refine_mesh(deck).deck;
  }
}

// A line that bends before the end is through is followed no further.
TEST(MemberCorners, StopWhereTheLineBends) {
  const Deck deck = deck_of(
      "BEGIN BULK\nGRID,1,,0.,-.1,0.\nGRID,2,,0.,0.,0.\nGRID,3,,0.,.1,0.\n"
      "GRID,4,,.002,0.,0.\nGRID,5,,.004,.0002,0.\n"
      "CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\n"
      "CBAR,3,1,2,4,0.,0.,1.\nCBAR,4,1,4,5,0.,0.,1.\n"
      "PBAR,1,1,4e-4,1.33333333e-8,1.33333333e-8,2e-8\n"
      "MAT1,1,2.1+11,,.3,7850.\nENDDATA\n");
  const MemberCorners corners = member_corners(deck);
  ASSERT_EQ(corners.ends.size(), 1U);
  ASSERT_EQ(corners.ends[0].inside.size(), 1U);
  EXPECT_EQ(corners.ends[0].inside[0].second, 1.0);
}

}  // namespace
}  // namespace tapfit::structure
