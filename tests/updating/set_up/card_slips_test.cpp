#include "updating/set_up/card_slips.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/mistakes.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

TEST(CardSlips, OfBarsAreTheirSecondMoments) {
  structure::Deck deck;
  deck.grids = {{1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {2, 0, 0}}};
  deck.bars = {structure::make_bar(7, 3, 1, 2),
               structure::make_bar(5, 3, 2, 3)};
  deck.bar_properties[3] = {3, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};
  deck.bar_properties[3].where = "beam.bdf:12 PBEAM 3";
  deck.bar_properties[4] = {4, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};  // not in use
  const auto slips = card_slips(deck);
  ASSERT_EQ(slips.size(), 1U);
  EXPECT_EQ(slips[0].edit, "model: PBEAM 3, exchange I1 and I2");
  EXPECT_EQ(slips[0].elements, (std::vector<int>{5, 7}));
  ASSERT_EQ(slips[0].numbers.size(), 2U);
  EXPECT_EQ(slips[0].numbers[0].number.property, "I1");
  EXPECT_NEAR(slips[0].numbers[0].factor, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(slips[0].numbers[1].factor, 3.0, 1e-12);
  slips[0].correct(deck);
  EXPECT_EQ(deck.bar_properties[3].I1, 1e-8);
  EXPECT_EQ(deck.bar_properties[3].I2, 3e-8);
  EXPECT_EQ(deck.bar_properties[3].J, 2e-8);
  deck.bar_properties[3].I2 = deck.bar_properties[3].I1;
  EXPECT_TRUE(card_slips(deck).empty()) << "a round bar";
  deck.bar_properties[3].I2 = 0.0;
  EXPECT_TRUE(card_slips(deck).empty()) << "it bends in one plane";
}

TEST(CardSlips, AreEffectsOfTheDeckOnTheirElements) {
  structure::Deck deck = support::plate_deck(true);
  const acquisition::TestBundle bundle = support::plate_bundle();
  const effects::TestContext context = support::plate_context(bundle, deck);
  const effects::Effect& swap = effects::card_swap();
  EXPECT_TRUE(swap.corrects_deck());
  EXPECT_TRUE(swap.is_mistake());
  EXPECT_TRUE(swap.shows_in_modes());
  const std::vector<Location> places = swap.places(context);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[1].variant, "T-by-2");
  const double thickness = deck.shell_properties[1].thickness;
  swap.correct_deck(places[1], deck);
  EXPECT_EQ(deck.shell_properties[1].thickness, 0.5 * thickness);
  Location none = places[0];
  none.elements.pop_back();
  swap.correct_deck(none, deck);
  EXPECT_EQ(deck.shell_properties[1].thickness, 0.5 * thickness);
}

TEST(CardSlips, OfAnOrthotropicPlateAreModuliAndThickness) {
  structure::Deck deck = support::plate_deck(true);
  deck.materials[1].orthotropic = true;
  deck.materials[1].E2 = 5e9;
  deck.materials[1].nu = 0.3;
  EXPECT_EQ(card_slips(deck).size(), 2U) << "exchanged, they are not elastic";
  deck.materials[1].nu = 0.05;
  const auto slips = card_slips(deck);
  ASSERT_EQ(slips.size(), 3U);
  EXPECT_EQ(slips[0].edit, "model: MAT8 1, exchange E1 and E2");
  EXPECT_EQ(slips[0].elements.size(), deck.shells.size());
  EXPECT_EQ(slips[1].edit, "model: PSHELL 1, T times 2");
  slips[0].correct(deck);
  EXPECT_EQ(deck.materials[1].E, 5e9);
  EXPECT_EQ(deck.materials[1].E2, 70e9);
  slips[2].correct(deck);
  EXPECT_NEAR(deck.shell_properties[1].thickness, 0.0015, 1e-12);
}

}  // namespace
}  // namespace tapfit::updating
