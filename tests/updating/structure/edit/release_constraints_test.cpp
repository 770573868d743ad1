#include "updating/structure/edit/release_constraints.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/deck/constraint_axes.hpp"

namespace tapfit::structure {
namespace {

std::string grids() {
  std::string text;
  for (int id = 1; id <= 12; ++id) {
    text += "GRID," + std::to_string(id) + ",,0.,0.," + std::to_string(id) +
            (id == 12 ? ".,,126\n" : ".\n");
  }
  return text;
}

// What each grid is held in, after cards are read again.
std::map<int, std::set<char>> held(const Deck& deck) {
  std::map<int, std::set<char>> result;
  for (const auto& [grid, components] : held_by_grid(deck)) {
    result[grid].insert(components.begin(), components.end());
  }
  return result;
}

void expect_released(const std::string& cards,
                     const std::vector<Constraint>& released) {
  const Deck deck = deck_of(grids() + cards);
  std::string text;
  for (const std::string& line :
       edit_cards(deck.path, {release_constraints(deck, released)})) {
    text += line + "\n";
  }
  auto expected = held(deck);
  for (const Constraint& out : released) {
    for (const char c : out.components) expected[out.grid].erase(c);
    if (expected[out.grid].empty()) expected.erase(out.grid);
  }
  EXPECT_EQ(held(read_deck(write_text("released.bdf", text))), expected)
      << text;
}

TEST(ReleaseConstraints, LeavesEverythingElseHeld) {
  expect_released("SPC1,1,123456,1,2,3,4,5,6\n,7,8,9,10\n",
                  {{2, "4"}, {3, "4"}, {10, "5"}});
  expect_released("SPC1,1,123456,2,THRU,20\n", {{12, "4"}, {2, "4"}});
  expect_released("SPC,1,3,12,,4,345\nSPC1,2,6,4\n", {{4, "3"}, {4, "6"}});
}

TEST(ReleaseConstraints, TakesPermanentConstraintsOffTheGrid) {
  expect_released("", {{12, "2"}, {12, "6"}});
  expect_released("", {{12, "126"}});
}

// Grid 1 leads; what it leads is released alike, in part, and wholly.
TEST(ReleaseConstraints, TakesWhatFollowsAHeldGridOffItsRigidElement) {
  const std::string clamp =
      "SPC1,1,123456,1\nRBE2,50,1,123456,2,3,4,5,6\n,7,8\n";
  const std::vector<Constraint> along = {
      {2, "4"}, {3, "4"}, {4, "4"}, {5, "4"}, {6, "4"}, {7, "4"}, {8, "4"}};
  expect_released(clamp, along);
  expect_released(clamp, {{3, "4"}, {7, "45"}});
  expect_released(clamp, {{2, "123456"}});
  expect_released("SPC1,1,123456,1\nRBAR,50,1,2,123456,,,12345\n", {{2, "4"}});
  expect_released("SPC1,1,123456,1\nRBAR,50,1,2,123456,,,4\n", {{2, "4"}});
}

TEST(ReleaseConstraints, LeavesOneRigidElementWhereAllAreReleasedAlike) {
  const Deck deck =
      deck_of(grids() + "SPC1,1,123456,1\nRBE2,50,1,123456,2,3\n");
  const auto lines =
      edit_cards(deck.path, {release_constraints(deck, {{2, "4"}, {3, "4"}})});
  EXPECT_NE(std::ranges::find(lines, "RBE2,50,1,12356,2,3"), lines.end());
}

TEST(ReleaseConstraints, LeavesOtherCardsAsWritten) {
  const Deck deck = deck_of(grids() + "SPC1,1,123456,1,2\nSPC1,1,3,5\n");
  const auto lines =
      edit_cards(deck.path, {release_constraints(deck, {{5, "3"}})});
  EXPECT_NE(std::find(lines.begin(), lines.end(), "SPC1,1,123456,1,2"),
            lines.end());
  EXPECT_NE(std::find(lines.begin(), lines.end(), "$ was: SPC1,1,3,5"),
            lines.end());
}

}  // namespace
}  // namespace tapfit::structure
