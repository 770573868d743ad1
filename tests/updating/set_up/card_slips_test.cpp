#include "updating/set_up/card_slips.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/card_units.hpp"
#include "updating/set_up/mistakes.hpp"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

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
  put_right(deck, slips[0]);
  EXPECT_EQ(deck.bar_properties[3].I1, 1e-8);
  EXPECT_EQ(deck.bar_properties[3].I2, 3e-8);
  EXPECT_EQ(deck.bar_properties[3].J, 2e-8);
  deck.bar_properties[3].I2 = deck.bar_properties[3].I1;
  EXPECT_TRUE(card_slips(deck).empty()) << "a round bar";
  deck.bar_properties[3].I2 = 0.0;
  EXPECT_TRUE(card_slips(deck).empty()) << "it bends in one plane";
}

TEST(CardSlips, OfMostElementsComeFirst) {
  structure::Deck deck;
  deck.grids = {{1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {2, 0, 0}}, {4, {3, 0, 0}}};
  deck.bars = {structure::make_bar(7, 3, 1, 2),
               structure::make_bar(5, 4, 2, 3),
               structure::make_bar(6, 4, 3, 4)};
  deck.bar_properties[3] = {3, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};
  deck.bar_properties[4] = {4, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};
  const auto slips = card_slips(deck);
  ASSERT_EQ(slips.size(), 2U);
  EXPECT_EQ(slips[0].elements, (std::vector<int>{5, 6}));
  EXPECT_EQ(slips[1].elements, (std::vector<int>{7}));
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
  put_right(deck, slips[0]);
  EXPECT_EQ(deck.materials[1].E, 5e9);
  EXPECT_EQ(deck.materials[1].E2, 70e9);
  put_right(deck, slips[2]);
  EXPECT_NEAR(deck.shell_properties[1].thickness, 0.0015, 1e-12);
}

std::vector<std::string> kinds_of(const structure::Deck& deck) {
  std::vector<std::string> kinds;
  for (const CardSlip& slip : unit_slips_of(deck)) {
    EXPECT_TRUE(slip.from_other_unit);
    EXPECT_THAT(slip_kinds(), testing::Contains(slip.kind));
    kinds.push_back(slip.kind);
  }
  return kinds;
}

TEST(CardSlips, AreUnitsInWhichAMaterialIsASolid) {
  structure::Deck deck = support::plate_deck(true);
  EXPECT_TRUE(unit_slips_of(deck).empty());
  structure::Material& aluminium = deck.materials[1];
  const double G = aluminium.G;
  aluminium.E *= 1e-6;
  aluminium.G *= 1e-6;
  const std::vector<CardSlip> slips = unit_slips_of(deck);
  EXPECT_THAT(kinds_of(deck), testing::Contains("E-in-MPa"));
  EXPECT_THAT(kinds_of(deck), testing::Not(testing::Contains("E-in-GPa")));
  EXPECT_EQ(slips[0].edit, "model: material 1, E from MPa to SI");
  EXPECT_EQ(slips[0].elements.size(), deck.shells.size());
  put_right(deck, slips[0]);
  EXPECT_NEAR(aluminium.E, 70e9, 1.0);
  EXPECT_NEAR(aluminium.G, G, 1.0);
  aluminium.E = 70.0;
  EXPECT_THAT(kinds_of(deck), testing::Contains("E-in-GPa"));
  aluminium.E = 10e6;
  EXPECT_THAT(kinds_of(deck), testing::Contains("E-in-psi"));
  aluminium.E = 70e9;
  aluminium.rho = 2.7e-6;
  EXPECT_THAT(kinds_of(deck), testing::ElementsAre("RHO-in-kg/mm3"));
  aluminium.rho = 2.7e-9;
  EXPECT_THAT(kinds_of(deck), testing::ElementsAre("RHO-in-t/mm3"));
  aluminium.rho = 0.0975;
  EXPECT_THAT(kinds_of(deck), testing::Contains("RHO-in-lb/in3"));
}

TEST(CardSlips, AreUnitsInWhichASectionFitsTheStructure) {
  structure::Deck deck = support::plate_deck(true);
  const double thickness = deck.shell_properties[1].thickness;
  deck.shell_properties[1].thickness *= 1000.0;
  EXPECT_THAT(kinds_of(deck), testing::Contains("T-in-mm"));
  for (const CardSlip& slip : unit_slips_of(deck)) {
    if (slip.kind == "T-in-mm") put_right(deck, slip);
  }
  EXPECT_NEAR(deck.shell_properties[1].thickness, thickness, 1e-12);
  structure::Deck beam;
  beam.grids = {{1, {0, 0, 0}}, {2, {0.2, 0, 0}}, {3, {0.4, 0, 0}}};
  beam.bars = {structure::make_bar(7, 3, 1, 2),
               structure::make_bar(5, 3, 2, 3)};
  beam.bar_properties[3] = {3, 1, 240.0, 1280.0, 18000.0, 0.0, 4260.0};
  EXPECT_THAT(kinds_of(beam), testing::Contains("section-in-mm"));
  put_right(beam, unit_slips_of(beam)[0]);
  EXPECT_NEAR(beam.bar_properties[3].area, 2.4e-4, 1e-16);
  EXPECT_NEAR(beam.bar_properties[3].I1, 1.28e-9, 1e-21);
  EXPECT_NEAR(beam.bar_properties[3].I2, 1.8e-8, 1e-20);
  EXPECT_NEAR(beam.bar_properties[3].J, 4.26e-9, 1e-21);
}

}  // namespace
}  // namespace tapfit::updating
