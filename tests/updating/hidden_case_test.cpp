#include "updating/hidden_case.hpp"

#include "updating/virtual_habit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

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

TEST(HiddenCase, TakesTheStructureThatIsAskedFor) {
  for (const std::string& name : virtual_structures()) {
    EXPECT_EQ(draw_hidden_case("none", 7, name).structure, name);
  }
  EXPECT_EQ(draw_hidden_case("soft-support", 7, "portal").structure, "portal");
}

TEST(HiddenCase, EveryKindCanBeHiddenInThePortal) {
  // The structure of bars: no shell edges for joints, supports and patches.
  for (const std::string& kind : hidden_kinds()) {
    const VirtualBundleSpec spec = draw_hidden_case(kind, 7, "portal");
    const auto joined = std::count(kind.begin(), kind.end(), '+');
    EXPECT_EQ(spec.effects.size(),
              kind == "none" ? 0U : static_cast<std::size_t>(joined) + 1U)
        << kind;
    for (const VirtualEffect& effect : spec.effects) {
      for (const double value : effect.values) EXPECT_NE(value, 0.0) << kind;
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
