#include "updating/practice/practice_case.hpp"

#include "updating/virtual_test/structure_presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

TEST(HiddenCase, SameSeedHidesTheSame) {
  const VirtualBundleSpec a = draw_practice_case("added-mass", 7);
  const VirtualBundleSpec b = draw_practice_case("added-mass", 7);
  EXPECT_EQ(a.structure, b.structure);
  ASSERT_EQ(a.effects.size(), 1U);
  EXPECT_EQ(a.effects[0].places, b.effects[0].places);
  EXPECT_EQ(a.effects[0].values, b.effects[0].values);
  EXPECT_TRUE(draw_practice_case("none", 7).effects.empty());
}

TEST(HiddenCase, PairsHideTwo) {
  const auto spec = draw_practice_case("added-mass+channel-gain", 3);
  ASSERT_EQ(spec.effects.size(), 2U);
  EXPECT_EQ(spec.effects[0].name, "added-mass");
  EXPECT_EQ(spec.effects[1].name, "channel-gain");
}

TEST(HiddenCase, TakesTheStructureThatIsAskedFor) {
  for (const std::string& name : virtual_structures()) {
    EXPECT_EQ(draw_practice_case("none", 7, name).structure, name);
  }
  EXPECT_EQ(draw_practice_case("soft-support", 7, "portal").structure,
            "portal");
}

TEST(HiddenCase, EveryKindCanBeHiddenInThePortal) {
  // The structure of bars: no shell edges for joints, supports and patches.
  for (const std::string& kind : practice_kinds()) {
    const VirtualBundleSpec spec = draw_practice_case(kind, 7, "portal");
    const auto joined = std::count(kind.begin(), kind.end(), '+');
    EXPECT_EQ(spec.effects.size(),
              kind == "none" ? 0U : static_cast<std::size_t>(joined) + 1U)
        << kind;
    for (const VirtualEffect& effect : spec.effects) {
      for (const double value : effect.values) EXPECT_NE(value, 0.0) << kind;
    }
  }
}

TEST(HiddenCase, WhatIsDrawnCanBeWrittenDownAndReadAgain) {
  for (const std::string& kind : practice_kinds()) {
    for (const VirtualEffect& effect : draw_practice_case(kind, 11).effects) {
      const std::string text = virtual_effect_text(effect);
      EXPECT_EQ(parse_virtual_effect(text), effect) << text;
    }
  }
}

TEST(HiddenCase, FormsAreDrawnAsTheirNamesSay) {
  const auto drawn = [](const std::string& kind) {
    return draw_practice_case(kind, 7).effects.at(0);
  };
  const VirtualEffect moving = drawn("moving-soft-support");
  EXPECT_EQ(moving.name, "soft-support");
  EXPECT_EQ(moving.form, "translation");
  EXPECT_EQ(moving.values.size(), 1U);
  const VirtualEffect loose = drawn("turning-and-moving-soft-support");
  EXPECT_EQ(loose.form, "both");
  EXPECT_EQ(loose.values.size(), 2U);
  // Sensors of two makes: far enough apart to be no scatter.
  const VirtualEffect unequal = drawn("unequal-sensor-mass");
  EXPECT_EQ(unequal.name, "sensor-mass");
  ASSERT_EQ(unequal.values.size(), 2U);
  EXPECT_GT(std::abs(std::log(unequal.values[0] / unequal.values[1])), 0.4);
}

}  // namespace
}  // namespace tapfit::updating
