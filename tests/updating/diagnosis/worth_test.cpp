#include "updating/diagnosis/worth.hpp"

#include "tests/updating/support/hidden_in_plate.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

// Mesh and form may leave 10 %, the hits scatter by 1 %.
constexpr Floor wide{0.10, 0.01};
// There is noise alone.
constexpr Floor narrow{0.02, 0.02};

TEST(Floors, LeaveNothingToExplainAtTheNoise) {
  EXPECT_TRUE(is_explained(0.025, narrow));
  EXPECT_FALSE(is_explained(0.027, narrow));  // 1.3 times
  EXPECT_TRUE(is_explained(0.029, wide));
  EXPECT_FALSE(is_explained(0.031, wide));  // three times the noise
}

TEST(Floors, OfMeshAndFormMayHideAnEffect) {
  EXPECT_TRUE(may_hide_effect(0.12, wide));
  EXPECT_FALSE(may_hide_effect(0.14, wide));  // above: it does not hide
  EXPECT_FALSE(may_hide_effect(0.02, wide));  // all of it may be noise
  EXPECT_FALSE(may_hide_effect(0.02, narrow));
}

TEST(AnUnexplainedError, IsFarAboveFloorAndBase) {
  EXPECT_TRUE(is_unexplained(0.4, 0.1, 1.0, false));
  EXPECT_FALSE(is_unexplained(0.25, 0.1, 1.0, false));
  // With effects in the model, also above a tenth of what was left without.
  EXPECT_FALSE(is_unexplained(0.09, 0.01, 1.0, true));
  EXPECT_TRUE(is_unexplained(0.11, 0.01, 1.0, true));
  // A base worse than no answer at all lends no explanation.
  EXPECT_TRUE(is_unexplained(0.2, 0.01, 50.0, true));
}

// Grids 1 + i + 11 j of ten by four shells, numbered alike.
TEST(WhatGivesWay, IsOneWhereAnElementJoinsIt) {
  const structure::Deck deck = support::plate_deck(true);
  const auto loss = [](std::vector<int> elements) {
    Location where;
    where.elements = std::move(elements);
    return EffectInstance{&effects::find("stiffness-loss"), where, {0.5}};
  };
  Location line;
  line.nodes = {5, 16, 27};
  const EffectInstance joint{&effects::find("joint"), line, {1e6}};
  Location grid;
  grid.node = 16;
  const EffectInstance mass{&effects::find("added-mass"), grid, {0.1}};
  EXPECT_TRUE(give_way_together(joint, loss({14}), deck));  // 16 is a corner
  EXPECT_TRUE(give_way_together(loss({14}), joint, deck));
  EXPECT_TRUE(give_way_together(joint, loss({16}), deck));  // 17 is next
  EXPECT_TRUE(give_way_together(loss({16}), joint, deck));
  EXPECT_FALSE(give_way_together(joint, loss({17}), deck));  // from 18 on
  EXPECT_FALSE(give_way_together(joint, mass, deck));
}

class ToldFromNone : public support::HiddenInPlate {
 protected:
  // Hidden and fitted.
  Fit fit_of(const EffectInstance& effect) {
    hide({effect});
    return fitter_->fit({effect}, fitter_->model_for({effect}));
  }

  // With that deviation of the logarithm of its size.
  static bool is_told_with(Fit fit, double sd) {
    const Eigen::Index own = fit.result.covariance.rows() - 1;
    fit.result.covariance(own, own) = sd * sd;
    return is_told(fit);
  }
};

// A tenth less in one element of a plate: modes move by less than 0.3 %.
TEST_F(ToldFromNone, IsALossWhoseIntervalEndsBefore) {
  Location where;
  where.elements = {12};
  const Fit fit = fit_of({&effects::find("stiffness-loss"), where, {0.9}});
  const double away = std::log(1.0 / fit.effects[0].p[0]);
  EXPECT_TRUE(is_told_with(fit, away / 2.0));
  EXPECT_FALSE(is_told_with(fit, away / 1.9));
}

// What each mode's form alone would do to the size is no measure of what the
// effect does to all modes.
TEST_F(ToldFromNone, IsALossThatMovesModesMoreThanFormsDo) {
  Location where;
  where.elements = {12};
  const Fit fit = fit_of({&effects::find("stiffness-loss"), where, {0.2}});
  EXPECT_TRUE(is_told_with(fit, 10.0));
}

// Of supports it is what they give.
TEST_F(ToldFromNone, IsNoSupportThatGivesNextToNothing) {
  const effects::Effect& effect = effects::find("soft-support");
  Location clamp =
      effect.places(support::plate_context(bundle_, deck_)).front();
  clamp.variant = "rotation";
  StiffnessChange change;
  change.kind = ChangeKind::Support;
  change.of = {effect.name(), clamp};
  const double start = builder_.build({}, {change}).terms.front().start;
  EXPECT_TRUE(is_told_with(fit_of({&effect, clamp, {start}}), 10.0));
  const Fit stiff = fit_of({&effect, clamp, {1000.0 * start}});
  EXPECT_TRUE(is_told_with(stiff, 0.5));
  EXPECT_FALSE(is_told_with(stiff, 0.52));
}

// Masses and gains are no forms of a deck.
TEST_F(ToldFromNone, IsWhatGivesNoWayByTheEvidence) {
  Location where;
  where.node = 31;
  const Fit fit = fit_of({&effects::find("added-mass"), where, {1e-4}});
  EXPECT_TRUE(is_told_with(fit, 10.0));
}

}  // namespace
}  // namespace tapfit::updating
