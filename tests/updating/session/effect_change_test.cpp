#include "updating/session/effect_change.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/session/added_effect.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Effects = std::vector<AddedEffect>;

EffectRef mass_at(int node) {
  Location where;
  where.node = node;
  return {"added-mass", where};
}

TEST(EffectChange, TellsWhatLeadsThroughTheStates) {
  const Effects one{{mass_at(5), true}};
  const Effects two{{mass_at(5), true}, {mass_at(7), true}};
  const Effects off{{mass_at(5), false}, {mass_at(7), true}};
  const std::vector<Effects> states{off, two, one};  // the next one last
  const std::vector<EffectChange> changes = changes_through({}, states);
  EXPECT_EQ(changes,
            (std::vector<EffectChange>{
                {{}, 0}, {{mass_at(7)}, {}}, {{mass_at(5)}, {}}}));
  EXPECT_EQ(states_through({}, changes), states);
}

TEST(EffectChange, OfSeveralAddedTogetherIsOne) {
  const Effects both = with_added({}, {mass_at(5), mass_at(7)});
  EXPECT_FALSE(both[0].together);
  EXPECT_TRUE(both[1].together);
  const std::vector<EffectChange> changes = changes_through({}, {both});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].added.size(), 2U);
  EXPECT_EQ(states_through({}, changes), std::vector<Effects>{both});
}

TEST(EffectChange, EndsWhereItIsNoSingleChange) {
  const Effects one{{mass_at(5), true}};
  EXPECT_TRUE(changes_through({}, {}).empty());
  EXPECT_TRUE(changes_through(one, {one}).empty());
  EXPECT_EQ(changes_through({}, {{}, one}).size(), 1U);
  const Effects two{{mass_at(5), true}, {mass_at(7), true}};
  EXPECT_TRUE(changes_through({}, {two}).empty());  // two steps
}

TEST(EffectChange, RefusesToSwitchWhatIsNotThere) {
  EXPECT_THROW((void)states_through({}, {{{}, 0}}), InputError);
}

TEST(CountedTwice, NamesTheChannelsThatHaveItAlready) {
  const EffectRef both{"sensor-mass", {.channels = {"acc1", "acc2"}}};
  const EffectRef one{"sensor-mass", {.channels = {"acc1"}}};
  const EffectRef other{"channel-gain", {.channels = {"acc1"}}};
  EXPECT_EQ(counted_twice({both}, {one}),
            "sensor-mass now counts twice at acc1: the sizes add up there");
  EXPECT_EQ(counted_twice({}, {both, one}), counted_twice({both}, {one}));
  EXPECT_EQ(counted_twice({both}, {other}), "");
}

}  // namespace
}  // namespace tapfit::updating
