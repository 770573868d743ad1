#include "updating/structure/checks/element_shapes.hpp"

#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"

namespace tapfit::structure {
namespace {

// A square metre; the third grid is moved.
std::vector<std::string> warnings(double x, double y, double z) {
  return deck_of(fmt::format("BEGIN BULK\n"
                             "GRID,1,,0.,0.,0.\n"
                             "GRID,2,,1.,0.,0.\n"
                             "GRID,3,,{:.6f},{:.6f},{:.6f}\n"
                             "GRID,4,,0.,1.,0.\n"
                             "CQUAD4,7,1,1,2,3,4\n"
                             "PSHELL,1,1,0.01,1,,1\n"
                             "MAT1,1,7.+10,,0.33,2700.\n"
                             "ENDDATA\n",
                             x,
                             y,
                             z))
      .warnings;
}

TEST(ElementShapes, OfAnOrdinaryMeshAreNotMentioned) {
  EXPECT_TRUE(warnings(1.0, 1.0, 0.0).empty());
  EXPECT_TRUE(warnings(1.3, 0.8, 0.1).empty());
}

// One corner up by h puts all four h / 4 off the mean plane, whose diagonals
// are about 1.41 long: 5 % is at h = 0.28.
TEST(ElementShapes, ThatAreWarpedAreNamedWithTheirCard) {
  EXPECT_TRUE(warnings(1.0, 1.0, 0.26).empty());
  const auto texts = warnings(1.0, 1.0, 0.32);
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts[0], HasSubstr("CQUAD4"));
  EXPECT_THAT(texts[0], HasSubstr("5 % of the diagonal"));
}

TEST(ElementShapes, WithAnEdgeOfNoLengthToSpeakOfAreNamed) {
  EXPECT_TRUE(warnings(0.05, 1.0, 0.0).empty());
  const auto texts = warnings(0.005, 1.0, 0.0);
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts[0], HasSubstr("1/100 of the longest"));
}

}  // namespace
}  // namespace tapfit::structure
