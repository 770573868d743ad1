#include "updating/structure/checks/doubled_parts.hpp"

#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"

namespace tapfit::structure {
namespace {

// Two squares side by side on grids of their own.
const std::string open =
    "MAT1,1,7.+10,,.3,2700.\nPSHELL,1,1,0.01,1,,1\n"
    "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\n"
    "GRID,12,,1.,0.,0.\nGRID,15,,2.,0.,0.\nGRID,16,,2.,1.,0.\n"
    "GRID,13,,1.,1.,1.-9\nCQUAD4,1,1,1,2,3,4\nCQUAD4,2,1,12,15,16,13\n";

TEST(DoubledParts, GridsThatWereNotMergedAreNamed) {
  const auto texts = doubled_part_warnings(deck_of(open));
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts[0], HasSubstr("GRID 2 and 12, 3 and 13: at one place"));
  EXPECT_THAT(deck_of(open).warnings, testing::Contains(texts[0]));
}

TEST(DoubledParts, GridsThatAreJoinedAreMeant) {
  for (const char* joint : {"CELAS2,9,1.+6,2,5,12,5\nRBE2,10,3,123456,13\n",
                            "PBUSH,4,K,1.+6,1.+6,1.+6\nCBUSH,9,4,2,12,,,,0\n"
                            "RBE2,10,13,123456,3\n"}) {
    EXPECT_TRUE(doubled_part_warnings(deck_of(open + joint)).empty()) << joint;
  }
  // A grid that only marks a place is no part of the mesh.
  EXPECT_TRUE(
      doubled_part_warnings(
          deck_of("MAT1,1,7.+10,,.3,2700.\nPROD,1,1,1.-4\nGRID,1,,0.,0.,0.\n"
                  "GRID,2,,1.,0.,0.\nGRID,3,,1.,0.,0.\nCROD,1,1,1,2\n"))
          .empty());
}

TEST(DoubledParts, ShellsOnTopOfEachOtherAreNamed) {
  const Deck deck = deck_of(
      "MAT1,1,7.+10,,.3,2700.\nPSHELL,1,1,0.01,1,,1\n"
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\n"
      "GRID,4,,0.,1.,0.\nCQUAD4,1,1,1,2,3,4\nCQUAD4,8,1,2,3,4,1\n");
  const auto texts = doubled_part_warnings(deck);
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts[0], HasSubstr("model.bdf:8 CQUAD4 8 (on 1)"));
}

}  // namespace
}  // namespace tapfit::structure
