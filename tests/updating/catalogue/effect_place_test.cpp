#include "updating/catalogue/effect_place.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

class EffectPlace : public ::testing::Test {
 protected:
  std::string refusal(const std::string& text) const {
    try {
      static_cast<void>(place_effect(parse_effect(text), context_));
    } catch (const InputError& error) {
      return error.what();
    }
    return "taken";
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
  effects::TestContext context_ = support::plate_context(bundle_, deck_);
};

TEST_F(EffectPlace, ChannelsAreJoinedAsTheyAreTold) {
  const std::vector<std::string> both = {"acc1", "acc2"};
  EXPECT_EQ(parse_effect("sensor-mass@acc1:acc2").where.channels, both);
  EXPECT_EQ(parse_effect("sensor-mass@acc1,acc2").where.channels, both);
  EXPECT_EQ(refusal("sensor-mass@acc1,acc2"), "taken");
}

TEST_F(EffectPlace, AChannelMayBeNamedByANumber) {
  for (acquisition::Channel& channel : bundle_.channels) {
    if (channel.name == "acc1") channel.name = "1";
  }
  EXPECT_EQ(refusal("channel-gain@1"), "taken");
  EXPECT_EQ(refusal("sensor-mass@1"), "taken");
}

TEST_F(EffectPlace, FormsAreThoseThatTheEffectHas) {
  EXPECT_EQ(parse_effect("added-mass@30:rotary").where.variant, "rotary");
  EXPECT_EQ(parse_effect("sensor-mass@acc1:acc2:each").where.variant, "each");
  EXPECT_EQ(refusal("added-mass@30:rotary"), "taken");
  EXPECT_NE(refusal("added-mass@30:bogus").find("no form \"30:bogus\""),
            std::string::npos);
  EXPECT_NE(refusal("dashpot@30:rotary").find("no form"), std::string::npos);
  EXPECT_NE(refusal("soft-support@sideways").find("translation-varying"),
            std::string::npos);
}

// A point with coordinates is a place like a grid: at that, or beside it.
TEST_F(EffectPlace, APointOfTheTestIsOne) {
  structure::MeasuringPoint point;
  point.grid = -2;
  point.nearest = 30;
  point.foot = deck_.grid(30).position;
  deck_.measuring.push_back(point);
  point.grid = -3;
  point.foot = 0.7 * deck_.grid(30).position + 0.3 * deck_.grid(31).position;
  point.to_grid = (point.foot - deck_.grid(30).position).norm();
  deck_.measuring.push_back(point);
  const EffectInstance at_grid =
      place_effect(parse_effect("added-mass@P2"), context_);
  EXPECT_EQ(at_grid.where.node, 30);
  EXPECT_TRUE(at_grid.where.at.empty());
  const EffectInstance between =
      place_effect(parse_effect("added-mass@P3"), context_);
  EXPECT_EQ(between.where.node, 30);
  ASSERT_EQ(between.where.at.size(), 3U);
  EXPECT_DOUBLE_EQ(between.where.at[1], point.foot.y());
  EXPECT_NE(refusal("added-mass@P9").find("the test has no point P9"),
            std::string::npos);
}

TEST_F(EffectPlace, SupportsTakeTheirFormsAlongALine) {
  const std::vector<int> clamp = {1, 12, 23, 34, 45};
  for (const char* form :
       {"rotation", "both", "rotation-varying", "translation-varying"}) {
    const std::string text = std::string("soft-support@") + form;
    const EffectInstance alone = place_effect(parse_effect(text), context_);
    EXPECT_EQ(alone.where.variant, form);
    EXPECT_EQ(alone.where.nodes, clamp);
    EXPECT_EQ(alone.p.size(), form == std::string("rotation") ? 1U : 2U);
    const std::string at = std::string("soft-support@1:45:") + form;
    EXPECT_EQ(place_effect(parse_effect(at), context_).where, alone.where);
  }
  // Hinges on a wall: there is no turn to let go.
  for (structure::Constraint& c : deck_.constraints) c.components = "123";
  EXPECT_EQ(refusal("soft-support@translation-varying"), "taken");
  EXPECT_NE(refusal("soft-support@both").find("cannot sit there"),
            std::string::npos);
}

TEST_F(EffectPlace, RefusalsNameWhatIsNotThere) {
  EXPECT_NE(refusal("added-mass@99999").find("no grid 99999"),
            std::string::npos);
  EXPECT_NE(refusal("sensor-mass@acc9").find("no channel \"acc9\""),
            std::string::npos);
  EXPECT_NE(refusal("added-mass@201x").find("\"201x\" is no grid"),
            std::string::npos);
  EXPECT_NE(refusal("dashpot@acc1").find("\"acc1\" is no grid"),
            std::string::npos);
  EXPECT_NE(refusal("absorber@201x:early").find("\"201x\" is no grid"),
            std::string::npos);
  EXPECT_NE(refusal("ground-spring@30:31").find("sits at one grid"),
            std::string::npos);
  EXPECT_NE(refusal("channel-gain@30").find("no channel \"30\""),
            std::string::npos);
  // Grid 1 is in the clamp, 6 and 30 are on no one line.
  EXPECT_NE(refusal("added-mass@1").find("a grid of the model that can move"),
            std::string::npos);
  EXPECT_NE(refusal("joint@6:30").find("from free edge to free edge"),
            std::string::npos);
}

TEST_F(EffectPlace, ASpringActsAlongAnyAxisThatWasTested) {
  context_.component = 3;
  context_.components = {1, 3};
  const auto axis = [&](const std::string& text) {
    const EffectInstance spring = place_effect(parse_effect(text), context_);
    return spring.effect->interface_dofs(spring.where, context_, 0)
        .at(0)
        .component;
  };
  EXPECT_EQ(axis("ground-spring@30"), 3);
  EXPECT_EQ(axis("ground-spring@30:Z"), 3);
  EXPECT_EQ(axis("ground-spring@30:X"), 1);
  EXPECT_EQ(axis("absorber@30:X"), 1);
  EXPECT_EQ(place_effect(parse_effect("dashpot@30:Z"), context_).where.variant,
            "");
  EXPECT_NE(refusal("ground-spring@30:Y").find("axis"), std::string::npos);
  EXPECT_EQ(describe(parse_effect("dashpot@30:X").where), "node 30 along X");
}

TEST_F(EffectPlace, APointOfTheSheetMayBeAnyOtherGridOfTheModel) {
  const EffectInstance point = place_effect(
      parse_effect("point-mislabelled@acc2:36:33:run4-6"), context_);
  EXPECT_EQ(describe(point.where), "acc2 at node 33, not 36, in runs 4 to 6");
  // A sensor that stays has one point.
  EXPECT_EQ(place_effect(parse_effect("point-mislabelled@acc2:33"), context_)
                .where.nodes,
            std::vector{36});
  for (const char* open :
       {"point-mislabelled@hammer:33", "point-mislabelled@acc2:36:"}) {
    EXPECT_NE(refusal(open).find("the grid that the sheet has it at and the"),
              std::string::npos)
        << open;
  }
  EXPECT_NE(refusal("point-mislabelled@acc2:36:999").find("no grid 999"),
            std::string::npos);
  EXPECT_NE(refusal("point-mislabelled@acc2:36:36"), "taken");
  EXPECT_NE(refusal("point-mislabelled@acc2:12:33"), "taken")
      << "acc2 is not at 12 on the sheet";
  EXPECT_NE(refusal("point-mislabelled@acc2:36:33:run7"), "taken")
      << "there are six";
  EXPECT_NE(refusal("point-mislabelled@acc2").find("acc1:8:6"),
            std::string::npos);
  EXPECT_NE(refusal("point-mislabelled").find("acc1:8:6"), std::string::npos);
}

// They are averaged: what is in one of them is in the FRFs of both.
TEST_F(EffectPlace, RunsOfOnePlacementAreNamedTogether) {
  bundle_.runs[3].hammer.dof = bundle_.runs[1].hammer.dof;
  EXPECT_EQ(refusal("unit-factor@acc1:10:run2:run4"), "taken");
  EXPECT_EQ(refusal("unit-factor@acc1:10:run3"), "taken");
  const std::string together = "runs 2, 4 measured the same and are averaged";
  for (const char* part : {"unit-factor@acc1:10:run2",
                           "unit-factor@acc1:10:run4",
                           "point-mislabelled@acc2:36:33:run3-6"}) {
    EXPECT_NE(refusal(part).find(together), std::string::npos) << part;
  }
  EXPECT_NE(refusal("unit-factor@acc1:10:run7").find("the test has no run 7"),
            std::string::npos);
}

TEST_F(EffectPlace, MistakesOfASheetHaveTheirVariants) {
  EXPECT_EQ(refusal("direction-wrong@acc1:+X"), "taken");
  EXPECT_EQ(refusal("direction-wrong@hammer:28:-Z"), "taken");
  EXPECT_NE(refusal("direction-wrong@acc1:+Z"), "taken") << "as written";
  EXPECT_NE(refusal("direction-wrong@hammer:-Z"), "taken")
      << "its polarity, not one of its points";
  EXPECT_EQ(refusal("unit-factor@acc1:1000"), "taken");
  EXPECT_EQ(refusal("unit-factor@acc1:1/9.807:run4"), "taken");
  EXPECT_EQ(refusal("unit-factor@acc1:integrated"), "taken");
  EXPECT_NE(refusal("unit-factor@acc1:7").find("1000"), std::string::npos);
  EXPECT_EQ(refusal("support-mismatch@free"), "taken");
  EXPECT_EQ(refusal("support-mismatch@free-rotations"), "taken");
  EXPECT_NE(refusal("support-mismatch@rotation").find("free-X"),
            std::string::npos);
}

TEST_F(EffectPlace, ASupportThatTheDeckLacksHasToBeToldWhere) {
  const auto nodes = [&](const std::string& text) {
    return place_effect(parse_effect(text), context_).where.nodes;
  };
  const std::vector<int> inside = {17, 28};
  EXPECT_EQ(nodes("support-mismatch@17:28:held"), inside) << "any grids";
  EXPECT_EQ(nodes("support-mismatch@17:28:held-Z"), inside);
  EXPECT_NE(refusal("support-mismatch@held").find("5:10:held"),
            std::string::npos);
  EXPECT_NE(refusal("support-mismatch@1:12:held"), "taken") << "clamped";
  EXPECT_NE(refusal("support-mismatch@900:held").find("no grid 900"),
            std::string::npos);
  deck_.constraints.clear();
  const std::vector<int> tip = {11, 22, 33, 44, 55};
  EXPECT_EQ(nodes("support-mismatch@11:33:55:held"), tip) << "the edge";
  EXPECT_EQ(nodes("support-mismatch@11:33:55:held-Z"), tip);
  EXPECT_NE(refusal("support-mismatch@held"), "taken");
  EXPECT_NE(refusal("support-mismatch"), "taken");
}

TEST_F(EffectPlace, APlaceBetweenGridsLiesOnAnElementThere) {
  EffectRef ref = parse_effect("added-mass@30");
  const Eigen::Vector3d x = position_of(ref.where, deck_);
  ref.where.at = {x.x() + 0.01, x.y() + 0.005, x.z()};
  const EffectInstance placed = place_effect(ref, context_);
  EXPECT_EQ(placed.where, ref.where);
  EXPECT_EQ(describe(placed.where), "near node 30");
  double whole = 0.0;
  const auto dofs = placed.effect->interface_dofs(placed.where, context_, 0);
  for (const MotionShare& share : dofs.at(2).between) {
    if (share.component == 3) whole += share.weight;
  }
  EXPECT_NEAR(whole, 1.0, 1e-12);  // a rigid motion moves it along
  ref.where.at[2] += 0.1;
  EXPECT_THROW(static_cast<void>(place_effect(ref, context_)), InputError);
}

}  // namespace
}  // namespace tapfit::updating
