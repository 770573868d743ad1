// Cards that repeat the one before them: read, and written out where a deck is
// changed.
#include "updating/structure/cards/repeated_cards.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <fmt/ranges.h>

namespace tapfit::structure {
namespace {

std::vector<std::string> lines_of(const std::vector<std::string>& written) {
  std::vector<std::string> lines;
  for (const Card& card : written_out(cards_in(written))) {
    std::vector<std::string> fields = card.fields;
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
    lines.push_back(fmt::format("{}", fmt::join(fields, ",")));
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(RepeatedCards, AreWrittenOut) {
  EXPECT_EQ(lines_of({"GRID,101,17,1.0,10.5,,17,3456",
                      "=,*(1),=,*(0.2),==",
                      "=(2)",
                      "=,*2,=,0.,=,9.",
                      "MAT1,1,7.+10,,.3"}),
            (Lines{"GRID,101,17,1.0,10.5,,17,3456",
                   "GRID,102,17,1.2,10.5,,17,3456",
                   "GRID,103,17,1.4,10.5,,17,3456",
                   "GRID,104,17,1.6,10.5,,17,3456",
                   "GRID,106,17,0.,10.5,9.",
                   "MAT1,1,7.+10,,.3"}));
  // In columns, steps below zero and as bulk data writes them, whole reals.
  EXPECT_EQ(lines_of({"GRID    7               1.5     .25",
                      "=       *-1     =       *5.-1   *-2.5-1 ==",
                      "=2"}),
            (Lines{"GRID,7,,1.5,.25",
                   "GRID,6,,2.,0.",
                   "GRID,5,,2.5,-0.25",
                   "GRID,4,,3.,-0.5"}));
  // "==" ends with its line where another follows.
  EXPECT_EQ(lines_of({"CBAR,1,2,3,4,0.,1.,0.,,+a",
                      "+a,56,,.1",
                      "=,*1,=,*1,*1,==",
                      "+,=,=,.2"}),
            (Lines{"CBAR,1,2,3,4,0.,1.,0.,,56,,.1",
                   "CBAR,2,2,4,5,0.,1.,0.,,56,,.2"}));
}

TEST(RepeatedCards, OfNothingAreRefused) {
  EXPECT_THROW(lines_of({"=,*1"}), InputError);
  EXPECT_THROW(lines_of({"GRID,1,,0.", "=,*1,*1"}), InputError);
  EXPECT_THROW(lines_of({"GRID,1,,0.", "=,*x"}), InputError);
  EXPECT_THROW(lines_of({"GRID,1,,0.", "==,2"}), InputError);
  EXPECT_THROW(lines_of({"GRID,1,,0.", "=(2,"}), InputError);
  EXPECT_THROW(lines_of({"GRID,1,,0.", "=0"}), InputError);
  EXPECT_THROW(lines_of({"GRID,1,,0.", "=,*1", "=999999999"}), InputError);
  EXPECT_THROW(lines_of({"GRID,1,,0.", "=,*1", "=2,7"}), InputError);
}

const std::string strip =
    "GRID,1,,0.,0.,0.\n=,*1,=,*.1,==\n=2\n"
    "GRID,11,,0.,.1,0.\n=,*1,=,*.1,==\n=2\n"
    "CQUAD4,1,1,1,2,12,11\n=,*1,=,*1,*1,*1,*1\n=1\n"
    "PSHELL,1,1,.002,1,,1\n=,2,==\nMAT1,1,7.+10,,.3,2700.\n";

// The readers refuse an id that is too large by its own words.
TEST(RepeatedCards, GoBeyondWhatAnIdCanBe) {
  EXPECT_EQ(lines_of({"GRID,2147483647", "=,*1"}).back(), "GRID,2147483648");
}

// Changed cards are written out, those that go on from them stay as they were.
TEST(RepeatedCards, StayWhatTheyAreInAChangedDeck) {
  const Deck deck = deck_of(strip);
  ASSERT_EQ(deck.shells.size(), 3U);
  ASSERT_EQ(deck.grids.size(), 8U);
  EXPECT_DOUBLE_EQ(deck.grids[3].position.x(), 0.3);
  const CardEdit edit =
      [](const Card& card) -> std::optional<std::vector<Card>> {
    const bool wanted = (card.name() == "PSHELL" && card.fields[1] == "1") ||
                        (card.name() == "CQUAD4" && card.fields[1] == "2");
    if (!wanted) return std::nullopt;
    Card changed = card;
    if (card.name() == "PSHELL") changed.fields[3] = ".003";
    if (card.name() == "CQUAD4") changed.fields[2] = "2";
    return std::vector<Card>{changed};
  };
  std::string text;
  for (const std::string& line : edit_cards(deck.path, {edit})) {
    text += line + "\n";
  }
  EXPECT_THAT(text, HasSubstr("$ was: =1\n"));
  Deck expected = deck;
  expected.shell_properties.at(1).thickness = 0.003;
  expected.shells[1].property = 2;
  const Deck read = read_deck(write_text("strip.bdf", text));
  EXPECT_LT((assemble(read).K - assemble(expected).K).norm(),
            1e-12 * assemble(expected).K.norm())
      << text;
  EXPECT_LT((assemble(read).M - assemble(expected).M).norm(),
            1e-12 * assemble(expected).M.norm());
}

// What is only added leaves repetitions as they are written.
TEST(RepeatedCards, StayAsWrittenWhereNothingChanges) {
  const Deck deck = deck_of(strip);
  std::string text;
  for (const std::string& line : edit_cards(deck.path, {})) text += line + "\n";
  EXPECT_THAT(text, HasSubstr("\n=1\n"));
}

}  // namespace
}  // namespace tapfit::structure
