// A pulled bar: where it may be, what it is written as, and that the deck then
// has what the model had.
#include "tests/updating/support/deck_support.hpp"
#include "updating/effects/effects.hpp"
#include "updating/effects/preload.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tapfit::effects {
namespace {

// A cantilever of four bars; clamped at grid 5 as well where `both`.
std::string bar_text(bool both) {
  std::string text = "SOL 103\nCEND\nBEGIN BULK\n";
  for (int i = 0; i < 5; ++i) {
    text += fmt::format("GRID,{},,{:.1f},0.,0.\n", i + 1, 0.1 * i);
  }
  for (int i = 1; i < 5; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", i, i, i + 1);
  }
  text += "PBAR,1,1,2.4-4,1.28-9,1.8-8,4.3-9\nMAT1,1,2.1+11,,0.3,7850.\n";
  text += "SPC1,1,123456,1\n";
  if (both) text += "SPC1,1,123456,5\n";
  return text;
}

TestContext context_of(const structure::Deck& deck) {
  TestContext context;
  context.deck = &deck;
  return context;
}

TEST(Prestress, IsPulledWhereAnEndIsLooseAndPushedWhereNoneIs) {
  const structure::Deck loose =
      structure::deck_of(bar_text(false) + "ENDDATA\n");
  const Effect& effect = prestress();
  const std::vector<Location> wire = effect.places(context_of(loose));
  ASSERT_EQ(wire.size(), 1U);
  EXPECT_EQ(wire[0].elements, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(effect.parameters(wire[0], context_of(loose)).size(), 2U);

  const structure::Deck held = structure::deck_of(bar_text(true) + "ENDDATA\n");
  const std::vector<Location> both = effect.places(context_of(held));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].variant, "");
  EXPECT_EQ(both[1].variant, "compression");
  const auto pulled = effect.parameters(both[0], context_of(held));
  const auto pushed = effect.parameters(both[1], context_of(held));
  ASSERT_EQ(pulled.size(), 1U);
  ASSERT_EQ(pushed.size(), 1U);
  EXPECT_EQ(pulled[0].sign, 1.0);
  EXPECT_EQ(pushed[0].sign, -1.0);
}

TEST(Prestress, DeckHasTheStiffnessOfTheModel) {
  const structure::Deck deck =
      structure::deck_of(bar_text(false) + "ENDDATA\n");
  const Effect& effect = prestress();
  const Location where = effect.places(context_of(deck)).front();
  std::string text = bar_text(false);
  for (const std::string& card :
       effect.bulk_data(where, context_of(deck), {1500.0, 1000.0})) {
    text += card + "\n";
  }
  const structure::Deck read = structure::deck_of(text + "ENDDATA\n");
  const structure::System bare = structure::assemble(deck);
  const Eigen::MatrixXd added = structure::assemble(read).K - bare.K;
  const Preload unit = preload(deck, bare, where.elements, where);
  const Eigen::MatrixXd exact = 1500.0 * unit.along + 1000.0 * unit.side;
  // Numbers of 7 digits.
  EXPECT_LT((added - exact).norm(), 1e-6 * exact.norm());
}

// One K2GG is all that a deck can have.
TEST(Prestress, SecondMatrixIsLeftToTheUser) {
  structure::Deck deck = structure::deck_of(bar_text(false) + "ENDDATA\n");
  deck.stiffness_terms.push_back({{1, 1}, {3, 3}, 5.0});
  const Effect& effect = prestress();
  for (const std::string& card :
       effect.bulk_data(effect.places(context_of(deck)).front(),
                        context_of(deck),
                        {1500.0, 1000.0})) {
    EXPECT_TRUE(card.starts_with("$")) << card;
  }
}

// A square has no longest direction; what it is taken for does not hang on its
// mesh.
TEST(Members, SquareHasOneAxisWhateverItsMesh) {
  structure::Plate plate;
  for (const int n : {2, 3, 4}) {
    const structure::Deck deck = structure::plate_deck(plate, n, 5);
    const auto member = updating::axial_member(
        deck, updating::whole_members(deck).front(), false);
    ASSERT_TRUE(member);
    EXPECT_NEAR(std::abs(member->axis.x()), 1.0, 1e-9) << n;
    EXPECT_NEAR(member->length, 1.0, 1e-9) << n;
  }
}

}  // namespace
}  // namespace tapfit::effects
