#include "updating/structure/edit/hold_cards.hpp"

#include "tests/updating/support/deck_support.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace tapfit::structure {
namespace {

std::string row_of_grids() {
  std::string text;
  for (int id = 1; id <= 12; ++id) {
    text += fmt::format("GRID,{},,0.,0.,{}.\n", id, id);
  }
  return text;
}

std::map<int, std::set<char>> held_in(const Deck& deck) {
  std::map<int, std::set<char>> result;
  for (const Constraint& c : deck.constraints) {
    result[c.grid].insert(c.components.begin(), c.components.end());
  }
  return result;
}

TEST(HoldCards, HoldWhatTheySayWhenReadBack) {
  std::vector<Constraint> wanted = {{1, "3"}, {2, "123456"}};
  for (int id = 3; id <= 12; ++id) wanted.push_back({id, "123456"});
  const Deck deck = deck_of(row_of_grids());
  std::string text = row_of_grids();
  for (const std::string& card : hold_cards(deck, wanted)) text += card + "\n";
  std::map<int, std::set<char>> expected;
  for (const Constraint& c : wanted) {
    expected[c.grid] = {c.components.begin(), c.components.end()};
  }
  EXPECT_EQ(held_in(read_deck(write_text("held.bdf", text))), expected) << text;
}

TEST(HoldCards, AreInTheSetThatHoldsTheDeck) {
  EXPECT_EQ(constraint_set(deck_of(row_of_grids())), 1);
  EXPECT_EQ(constraint_set(deck_of(row_of_grids() + "SPC1,7,3,5\n")), 7);
  EXPECT_EQ(constraint_set(deck_of("SOL 103\nCEND\nspc = 4\nBEGIN BULK\n" +
                                   row_of_grids() +
                                   "SPC1,7,3,5\nSPC1,4,3,6\nENDDATA\n")),
            4);
}

// Its axes are turned by a quarter about z, and askew.
TEST(HoldCards, SayComponentsAlongTheGridsOwnAxes) {
  Deck deck = deck_of(row_of_grids());
  deck.grids[0].axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const auto quarter = hold_cards(deck, {{1, "1"}});
  ASSERT_EQ(quarter.size(), 1U);
  EXPECT_EQ(quarter[0], "SPC1,1,2,1");
  deck.grids[0].axes << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
  EXPECT_TRUE(hold_cards(deck, {{1, "1"}})[0].starts_with("$ grid 1"));
  EXPECT_EQ(hold_cards(deck, {{1, "123"}})[0], "SPC1,1,123,1");
}

}  // namespace
}  // namespace tapfit::structure
