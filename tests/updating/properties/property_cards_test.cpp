#include "updating/properties/property_cards.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/properties/uncertain_property.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <fstream>

namespace tapfit::updating {
namespace {

using acquisition::UncertainProperty;
using structure::Deck;

// Free, small and large field, continuations, a property of its own each.
constexpr const char* deck_text =
    "GRID,1,,0.,0.,0.\n"
    "GRID,2,,1.,0.,0.\n"
    "GRID,3,,1.,1.,0.\n"
    "GRID,4,,0.,1.,0.\n"
    "CQUAD4,1,1,1,2,3,4\n"
    "CQUAD4,2,4,1,2,3,4\n"
    "CBAR,11,2,1,2,0.,0.,1.\n"
    "CROD,21,3,1,3\n"
    "$ aluminium\n"
    "MAT1    1       7.0+10          .33     2700.\n"
    "MAT8*   2               1.2+10          .8+9            .4\n"
    "*       .75+9           .7+9            .1+9            417.\n"
    "PSHELL,1,1,.003,1,,1\n"
    "PSHELL,4,2,.005\n"
    "PBAR    2       1       1.-4    1.-8    2.-8    3.-8            +\n"
    "+       .01     .01\n"
    "PROD,3,1,2.-4,1.-9\n"
    "ENDDATA\n";

Deck written(const Deck& deck, const UncertainProperty& u, double factor) {
  const std::vector<structure::CardScale> scales = {
      property_card(deck, u, factor)};
  std::vector<bool> done;
  const std::vector<std::string> lines = structure::edit_cards(
      deck.path, {structure::rescale_cards(scales, done)});
  EXPECT_TRUE(done.at(0)) << u.property;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return structure::read_deck(structure::write_text("written.bdf", text));
}

// The deck read back is the deck scaled in memory: the two ways to apply a
// property agree, so that the exported deck has the FRFs that were fitted.
TEST(PropertyCards, ReadBackAsTheScaledModel) {
  const Deck deck = structure::deck_of(deck_text);
  const std::vector<UncertainProperty> all = {{"material", 1, "E"},
                                              {"material", 1, "rho"},
                                              {"material", 2, "E"},
                                              {"material", 2, "E1"},
                                              {"material", 2, "E2"},
                                              {"material", 2, "nu"},
                                              {"material", 2, "G12"},
                                              {"material", 2, "rho"},
                                              {"property", 1, "t"},
                                              {"property", 4, "t"},
                                              {"property", 2, "A"},
                                              {"property", 2, "I1"},
                                              {"property", 2, "I2"},
                                              {"property", 2, "J"},
                                              {"property", 3, "A"},
                                              {"property", 3, "J"}};
  for (const UncertainProperty& u : all) {
    Deck scaled = deck;
    scale_property(scaled, u, 1.0375);
    const Deck back = written(deck, u, 1.0375);
    const structure::System a = structure::assemble(scaled);
    const structure::System b = structure::assemble(back);
    // Nine digits are written.
    EXPECT_LT((a.K - b.K).norm(), 1e-8 * a.K.norm()) << u.property << u.id;
    EXPECT_LT((a.M - b.M).norm(), 1e-8 * a.M.norm()) << u.property << u.id;
    EXPECT_GT((structure::assemble(deck).K - b.K).norm() +
                  (structure::assemble(deck).M - b.M).norm(),
              0.0);
  }
}

TEST(PropertyCards, KeepTheOldLinesAsComments) {
  const Deck deck = structure::deck_of(deck_text);
  const std::vector<structure::CardScale> scales = {
      property_card(deck, {"property", 2, "I1"}, 2.0)};
  std::vector<bool> done;
  const std::vector<std::string> lines = structure::edit_cards(
      deck.path, {structure::rescale_cards(scales, done)});
  const auto at =
      std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
        return line.starts_with("$ was: PBAR");
      });
  ASSERT_NE(at, lines.end());
  EXPECT_TRUE((at + 1)->starts_with("$ was: +"));
  // In small field, as it came.
  EXPECT_EQ(
      *(at + 2),
      "PBAR    2       1       1.-4    2.-8    2.-8    3.-8            +");
  EXPECT_EQ(*(at + 3), "+       .01     .01");
}

TEST(PropertyCards, SayWhatHasNoCard) {
  const Deck deck = structure::deck_of(deck_text);
  const std::vector<structure::CardScale> scales = {
      property_card(deck, {"material", 1, "nu"}, 1.1)};
  std::vector<bool> done;
  static_cast<void>(structure::edit_cards(
      deck.path, {structure::rescale_cards(scales, done)}));
  EXPECT_FALSE(done.at(0));
}

}  // namespace
}  // namespace tapfit::updating
