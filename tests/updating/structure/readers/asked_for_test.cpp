// What of a deck is read: cards left out as asked, sets that the case control
// does not choose.
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"

namespace tapfit::structure {
namespace {

const std::string four_grids = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
PSHELL,1,1,0.01,1,,1
MAT1,1,7.+10,,.3,2700.
)";

// Also a card that is read; and a name that the deck does not have is said.
TEST(AskedFor, CardsAreLeftOutAsAsked) {
  const std::string text =
      four_grids + "CQUAD4,5,1,1,2,3,4\nCONM2,7,1,,2.\nCONM2,8,2,,2.\n";
  const Deck whole = deck_of(text);
  const Deck deck =
      read_deck(write_text("without.bdf", text), {"conm2", "NOSUCH"});
  EXPECT_EQ(whole.masses.size(), 2U);
  EXPECT_TRUE(deck.masses.empty());
  ASSERT_EQ(deck.warnings.size(), 2U);
  EXPECT_THAT(deck.warnings[0],
              HasSubstr("CONM2 (2 in all) left out, as asked"));
  EXPECT_THAT(deck.warnings[1], HasSubstr("no such card"));
}

// Nastran would solve the model free; without a case control nothing is asked.
TEST(AskedFor, SetThatTheCaseControlDoesNotChooseIsSaid) {
  const std::string bulk = "BEGIN BULK\n" + four_grids +
                           "CQUAD4,5,1,1,2,3,4\nSPC1,9,123,1\nENDDATA\n";
  const Deck deck = deck_of("SOL 103\nCEND\nMETHOD = 1\n" + bulk);
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_THAT(deck.warnings[0], HasSubstr("chooses no SPC"));
  EXPECT_THAT(deck.warnings[0], HasSubstr("write SPC = 9"));
  EXPECT_EQ(deck.constraints.size(), 1U);
  EXPECT_TRUE(deck_of(bulk).warnings.empty());
  EXPECT_TRUE(
      deck_of("SOL 103\nCEND\nMETHOD = 1\nSPC = 9\n" + bulk).warnings.empty());
}

}  // namespace
}  // namespace tapfit::structure
