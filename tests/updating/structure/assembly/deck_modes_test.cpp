// Motions without stiffness, told from those that are only weak beside the
// stiffness of an element.
#include "updating/structure/assembly/deck_modes.hpp"

#include "tests/updating/support/clamped_line.hpp"

#include <gmock/gmock.h>

namespace tapfit::structure {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

std::vector<std::string> notes_of(const Deck& deck) {
  return deck_modes(deck, assemble(deck), 8).warnings;
}

// The lowest mode of n bars has 12.4 / 24 n^4 of the energies that cancel in
// it: 5e-13 and 3e-14 of these, far more than rounding is.
TEST(DeckModes, FindNoMechanismInALongLine) {
  for (const int bars : {1000, 2000}) {
    EXPECT_TRUE(notes_of(clamped_line(bars, 0.01)).empty()) << bars;
  }
}

// A hinge within, about both axes.
TEST(DeckModes, FindTheHingeOfALine) {
  for (const int bars : {20, 1000}) {
    Deck deck = clamped_line(bars, 0.01);
    deck.bars[static_cast<std::size_t>(bars / 2)].released[0] = "56";
    EXPECT_THAT(notes_of(deck), Contains(HasSubstr("2 motions without")))
        << bars;
  }
}

// 6e-15 of 3000 bars may as well be rounding: said with what it may be.
TEST(DeckModes, SayWhatRoundingHides) {
  EXPECT_THAT(notes_of(clamped_line(3000, 0.01)),
              Contains(HasSubstr("not to be trusted")));
}

}  // namespace
}  // namespace tapfit::structure
