// GRDSET, BAROR and BEAMOR.
#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/edit/release_constraints.hpp"

namespace tapfit::structure {
namespace {

const std::string material =
    "MAT1,1,7.+10,,.3,2700.\nPBAR,2,1,1.-4,1.-9,2.-9\n"
    "PBAR,9,1,2.-4,1.-9,2.-9\n";

TEST(CardDefaults, FillWhatGridsLeaveBlank) {
  const Deck deck = deck_of(
      "CORD2R,5,,1.,0.,0.,1.,0.,1.\n,1.,1.,0.\nGRDSET,,5,,,,5,456\n"
      "GRID,1,,2.,0.,0.\nGRID,2,0,2.,0.,0.,0,0\n");
  // System 5 begins at x = 1, and its x is the basic y.
  EXPECT_EQ(deck.grids[0].position, Eigen::Vector3d(1.0, 2.0, 0.0));
  EXPECT_EQ(deck.grids[0].axes.col(0), Eigen::Vector3d::UnitY());
  EXPECT_EQ(deck.grids[1].position, Eigen::Vector3d(2.0, 0.0, 0.0));
  EXPECT_EQ(deck.grids[1].axes, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  ASSERT_EQ(deck.constraints.size(), 1U);
  EXPECT_EQ(deck.constraints[0].grid, 1);
  EXPECT_EQ(deck.constraints[0].components, "456");
}

TEST(CardDefaults, FillWhatBarsLeaveBlank) {
  for (const char* kind : {"CBAR", "CBEAM"}) {
    const std::string defaults =
        std::string(kind) == "CBAR" ? "BAROR" : "BEAMOR";
    const Deck deck = deck_of(
        material + "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,0.,1.\n" +
        fmt::format(
            "{0},,2,,,0.,1.,0.\n{1},7,,1,2\n{1},8,9,1,2,3\n", defaults, kind));
    ASSERT_EQ(deck.bars.size(), 2U);
    EXPECT_EQ(deck.bars[0].property, 2);
    EXPECT_EQ(deck.bars[0].orientation, Eigen::Vector3d::UnitY());
    // A bar's own grid G0 is not mixed with the defaults' vector.
    EXPECT_EQ(deck.bars[1].property, 9);
    EXPECT_EQ(deck.bars[1].orientation, Eigen::Vector3d::UnitZ());
    EXPECT_TRUE(deck.warnings.empty());
  }
}

TEST(CardDefaults, ReleasedComponentsStayReleased) {
  const Deck deck =
      deck_of("GRDSET,,,,,,,56\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n");
  std::string text;
  for (const std::string& line :
       edit_cards(deck.path, {release_constraints(deck, {{1, "56"}})})) {
    text += line + "\n";
  }
  const Deck released = deck_of(text);
  ASSERT_EQ(released.constraints.size(), 1U);
  EXPECT_EQ(released.constraints[0].grid, 2);
}

TEST(CardDefaults, SecondCardIsRefused) {
  EXPECT_THAT(
      [&] {
        static_cast<void>(deck_of("GRDSET,,,,,,,6\nGRDSET,,,,,,,5\nGRID,1\n"));
      },
      Throws<InputError>(AllOf(
          Property(&InputError::what, testing::HasSubstr("model.bdf:2 GRDSET")),
          Property(&InputError::what, testing::HasSubstr("model.bdf:1")))));
}

}  // namespace
}  // namespace tapfit::structure
