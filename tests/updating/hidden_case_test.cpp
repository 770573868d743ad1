#include "updating/hidden_case.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

VirtualBundleSpec hiding(const std::string& name,
                         const std::string& place,
                         double value) {
  VirtualBundleSpec spec;
  spec.effects = {{name, {place}, {value}}};
  return spec;
}

Diagnosis finding(const std::string& name, int node, double value) {
  Rung rung;
  rung.added = name;
  rung.where.node = node;
  rung.parameters = {{"mass_kg", value, 0.001, value - 0.002, value + 0.002}};
  Diagnosis diagnosis;
  diagnosis.verdict = name;
  diagnosis.ladder = {rung};
  return diagnosis;
}

TEST(HiddenCase, SameSeedHidesTheSame) {
  const VirtualBundleSpec a = draw_hidden_case("added-mass", 7);
  const VirtualBundleSpec b = draw_hidden_case("added-mass", 7);
  EXPECT_EQ(a.structure, b.structure);
  ASSERT_EQ(a.effects.size(), 1U);
  EXPECT_EQ(a.effects[0].places, b.effects[0].places);
  EXPECT_EQ(a.effects[0].values, b.effects[0].values);
  EXPECT_TRUE(draw_hidden_case("none", 7).effects.empty());
}

TEST(HiddenCase, PairsHideTwo) {
  const auto spec = draw_hidden_case("added-mass+channel-gain", 3);
  ASSERT_EQ(spec.effects.size(), 2U);
  EXPECT_EQ(spec.effects[0].name, "added-mass");
  EXPECT_EQ(spec.effects[1].name, "channel-gain");
}

TEST(Judge, TellsKindPlaceAndSize) {
  const structure::Deck deck = support::plate_deck(true);
  const VirtualBundleSpec hidden = hiding("added-mass", "30", 0.05);
  const Verdict right = judge(hidden, finding("added-mass", 30, 0.051), deck);
  EXPECT_TRUE(right.right_kind);
  EXPECT_TRUE(right.right_place);
  EXPECT_NEAR(right.size_error, 0.02, 1e-12);
  EXPECT_EQ(right.intervals_hold, 1);
  // The next grid is one element away, grid 28 two.
  EXPECT_TRUE(judge(hidden, finding("added-mass", 29, 0.05), deck).right_place);
  EXPECT_FALSE(
      judge(hidden, finding("added-mass", 28, 0.05), deck).right_place);
  EXPECT_FALSE(judge(hidden, finding("dashpot", 30, 0.05), deck).right_kind);
}

TEST(Judge, OutsideTheCatalogueUnexplainedIsRight) {
  const structure::Deck deck = support::plate_deck(true);
  VirtualBundleSpec strut;
  strut.effects = {{"strut", {"30", "20"}, {1e4}}};
  EXPECT_FALSE(judge(strut, finding("added-mass", 30, 0.05), deck).right_kind);
  Diagnosis honest;
  honest.verdict = "unexplained";
  EXPECT_TRUE(judge(strut, honest, deck).right_kind);
}

}  // namespace
}  // namespace tapfit::updating
