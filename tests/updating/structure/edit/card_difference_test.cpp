// Decks as a diff by card, and the table of measured damping.
#include "updating/structure/edit/card_difference.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/edit/damping_table.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

TEST(CardDifference, NamesWhatChangedAndNothingElse) {
  const auto before = write_text("before.bdf",
                                 "BEGIN BULK\nMAT1,1,7.+10,,.3,2700.\n"
                                 "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n"
                                 "SPC1,1,123,1\nENDDATA\n");
  const auto after = write_text("after.bdf",
                                "BEGIN BULK\nGRID,2,,1.0,0.,0.\n"
                                "GRID    1               0.      0.      0.\n"
                                "MAT1,1,7.2E10,,.3,2700.\n"
                                "CONM2,9,2,,.02\nENDDATA\n");
  const std::vector<CardChange> changes = card_difference(before, after);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].card, "MAT1 1");
  EXPECT_EQ(changes[0].where, "before.bdf:2");
  EXPECT_EQ(changes[0].before, "MAT1,1,7.+10,,.3,2700.");
  EXPECT_EQ(changes[0].after, "MAT1,1,7.2E10,,.3,2700.");
  EXPECT_EQ(changes[1].card, "SPC1 1");
  EXPECT_EQ(changes[1].after, "");
  EXPECT_EQ(changes[2].before, "");
  EXPECT_EQ(changes[2].after, "CONM2,9,2,,.02");
  EXPECT_TRUE(card_difference(before, before).empty());
}

// What Nastran goes on along beyond the ends is a line through two points of
// the same damping.
TEST(DampingTable, IsFlatBeyondItsEnds) {
  const auto deck = write_text("deck.bdf",
                               "BEGIN BULK\nGRID,1,,0.,0.,0.\n"
                               "TABLED1,7\n,0.,1.,1.,1.,ENDT\nENDDATA\n");
  ASSERT_EQ(free_table(deck), 8);
  std::string text = "BEGIN BULK\n";
  for (const std::string& line : damping_table_cards(
           8, {{10.0, 0.01}, {20.0, 0.02}, {30.0, 0.005}, {44.0, 0.008}})) {
    text += line + "\n";
  }
  const auto written = write_text("written.bdf", text + "ENDDATA\n");
  const std::vector<Card> cards = read_bulk_data(written).cards;
  ASSERT_EQ(cards.size(), 1U);
  const std::vector<std::string>& f = cards[0].fields;
  EXPECT_EQ(f[0], "TABDMP1");
  EXPECT_EQ(f[1], "8");
  EXPECT_EQ(f[2], "CRIT");
  const std::vector<double> wanted{
      0.0, 0.01, 10.0, 0.01, 20.0, 0.02, 30.0, 0.005, 44.0, 0.008, 88.0, 0.008};
  ASSERT_GE(f.size(), 9 + wanted.size() + 1);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    EXPECT_NEAR(std::stod(f[9 + k]), wanted[k], 1e-9) << k;
  }
  EXPECT_EQ(f[9 + wanted.size()], "ENDT");
  EXPECT_TRUE(damping_table_cards(1, {}).empty());
}

}  // namespace
}  // namespace tapfit::structure
