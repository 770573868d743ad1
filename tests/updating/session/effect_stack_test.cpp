#include "updating/session/effect_stack.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/fit/fit_observer.hpp"
#include "updating/measurement/damped_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tapfit::updating {
namespace {

EffectRef mass_at(int node) {
  EffectRef ref{"added-mass", {}};
  ref.where.node = node;
  return ref;
}

// The sample plate with 30 g on grid 9 and 20 g on grid 53, "measured" without
// noise: with both the error is nothing, with one of them it is large.
class EffectStackTest : public ::testing::Test, protected support::BasedPlate {
 protected:
  EffectStackTest() {
    FitProblem fit;
    fit.context = context_;
    fit.uncertain_sd = {0.03};
    fit.measured = support::plate_pairs(
        bundle_, damped_line({10.0, 400.0}, 3.0, {0.03, 120}));
    fit.targets = {make_target(fit.measured)};
    const Fitter bare(builder_, fit);
    const std::vector<EffectInstance> hidden = {
        {&effects::find("added-mass"), mass_at(9).where, {0.030}},
        {&effects::find("added-mass"), mass_at(53).where, {0.020}}};
    const auto model = bare.model_for(hidden);
    const Eigen::MatrixXcd H =
        model->respond(bare.first_state(*model, hidden), fit.measured.s, false)
            .H;
    for (Eigen::Index f = 0; f < H.cols(); ++f) {
      fit.measured.frfs[static_cast<std::size_t>(f)].H = H.col(f);
    }
    fit.targets = {make_target(fit.measured)};
    fitter_.emplace(builder_, fit);
    Fit base;
    base.model = fitter_->model_for({});
    base.result.state = fitter_->first_state(*base.model, {});
    stack_.emplace(base, true);
  }

  [[nodiscard]] StackFit how() const {
    return {fitter_->problem().context,
            [this](const std::vector<EffectInstance>& effects,
                   const Fit& before,
                   const Progress& progress) {
              return fitter_->fit(
                  effects, fitter_->model_for(effects), progress, &before);
            }};
  }
  [[nodiscard]] double error() const {
    return stack_->fits().back().result.error;
  }

  Progress none_;
  std::optional<Fitter> fitter_;
  std::optional<EffectStack> stack_;
};

TEST_F(EffectStackTest, SwitchingOffIsAsIfItHadNeverBeenAdded) {
  stack_->add(mass_at(53), how(), none_);
  const double second_alone = error();
  ASSERT_TRUE(stack_->undo(how(), none_));
  stack_->add(mass_at(9), how(), none_);
  stack_->add(mass_at(53), how(), none_);
  EXPECT_LT(error(), 1e-4);  // the data are the model's own
  // Base, what is uncertain, two effects.
  EXPECT_EQ(stack_->fits().size(), 4U);

  stack_->toggle(0, how(), none_);
  EXPECT_EQ(stack_->fits().size(), 3U);
  EXPECT_FALSE(stack_->effects()[0].on);
  EXPECT_TRUE(stack_->effects()[1].on);
  // The same fit, from the same start.
  EXPECT_NEAR(error(), second_alone, 1e-9 * second_alone);
  EXPECT_GT(error(), 0.01);

  stack_->toggle(0, how(), none_);
  EXPECT_LT(error(), 1e-4);
}

// In squares of the logarithm's deviation, through every change.
TEST_F(EffectStackTest, SaysAsUnsureASizeAsItsPlaceIs) {
  const auto sd_of_last = [this] {
    const std::size_t last = stack_->fits().back().effects.size() - 1;
    const Estimate e = effect_estimates(
        stack_->fits().back(), last, fitter_->problem().context)[0];
    return e.sd / e.value;
  };
  stack_->add(mass_at(53), how(), none_);
  stack_->add(mass_at(9), how(), none_);
  const double placed = sd_of_last();
  ASSERT_TRUE(stack_->undo(how(), none_));
  EffectRef unsure = mass_at(9);
  unsure.place_sd = {0.2};
  stack_->add(unsure, how(), none_);
  EXPECT_NEAR(sd_of_last(), std::hypot(placed, 0.2), 1e-9);
  ASSERT_TRUE(stack_->undo(how(), none_));
  ASSERT_TRUE(stack_->redo(how(), none_));
  EXPECT_NEAR(sd_of_last(), std::hypot(placed, 0.2), 1e-9);
}

// What was found is gone on from in every fit that has it.
TEST_F(EffectStackTest, StartsFromTheSizesThatWereFound) {
  std::vector<std::vector<double>> starts;
  StackFit watched = how();
  watched.fit = [&](const std::vector<EffectInstance>& effects,
                    const Fit& before,
                    const Progress& progress) {
    if (!effects.empty()) starts.push_back(effects.front().p);
    return how().fit(effects, before, progress);
  };
  EffectRef found = mass_at(9);
  found.start = {0.0123};
  stack_->add(found, watched, none_);
  stack_->add(mass_at(53), watched, none_);
  EXPECT_EQ(starts, (std::vector<std::vector<double>>{{0.0123}, {0.0123}}));
}

TEST_F(EffectStackTest, SaysWhereTheErrorDoesNotFall) {
  const std::string said = "the error does not fall";
  stack_->add(mass_at(9), how(), {});
  EXPECT_EQ(stack_->fits().back().result.message.find(said), std::string::npos);
  // Again what is there; then one that can do less than what it takes the place
  // of.
  StackFit again = how();
  double factor = 1.0;
  again.fit = [&](const std::vector<EffectInstance>& effects,
                  const Fit&,
                  const Progress&) {
    Fit fit = stack_->fits().back();
    fit.effects = effects;
    fit.result.message.clear();
    fit.result.error *= factor;
    return fit;
  };
  stack_->add(mass_at(30), again, {});
  EXPECT_NE(stack_->fits().back().result.message.find(said), std::string::npos);
  factor = 1.1;
  stack_->add(mass_at(40), again, {});
  EXPECT_NE(stack_->fits().back().result.message.find("leave it out"),
            std::string::npos);
}

// As when the FRFs behind a stack change: what was done is not lost.
TEST_F(EffectStackTest, ItsHistoryLivesOnInAnotherStack) {
  const Fit base = stack_->fits().front();
  stack_->add(mass_at(9), how(), none_);
  stack_->add(mass_at(53), how(), none_);
  const double both = error();
  stack_->toggle(0, how(), none_);
  ASSERT_TRUE(stack_->undo(how(), none_));
  const EffectHistory before = stack_->history();

  EffectStack other(base, true);
  other.restore(before, how(), none_);
  EXPECT_NEAR(other.fits().back().result.error, both, 1e-9);
  ASSERT_TRUE(other.redo(how(), none_));
  EXPECT_FALSE(other.effects()[0].on);
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(other.undo(how(), none_));
  EXPECT_TRUE(other.effects().empty());
  EXPECT_FALSE(other.undo(how(), none_));

  // Of effects alone, as a file has them.
  EffectStack third(base, true);
  third.restore(
      {{{mass_at(9), true}, {mass_at(53), false}}, {}, {}}, how(), none_);
  ASSERT_TRUE(third.undo(how(), none_));
  EXPECT_TRUE(third.effects()[1].on);
  ASSERT_TRUE(third.undo(how(), none_));
  EXPECT_EQ(third.effects().size(), 1U);
  EXPECT_THROW(
      third.restore(
          {{{mass_at(9), true}, {mass_at(9), true}}, {}, {}}, how(), none_),
      InputError);
}

// One step, and the same rungs to the last digit as one after the other.
TEST_F(EffectStackTest, AddsSeveralTogetherAsOneStep) {
  const Fit base = stack_->fits().front();
  stack_->add(mass_at(9), how(), none_);
  stack_->add(mass_at(53), how(), none_);
  const double apart = error();
  EffectStack other(base, true);
  other.add_together({mass_at(9), mass_at(53)}, how(), none_);
  EXPECT_EQ(other.fits().size(), 4U);
  EXPECT_DOUBLE_EQ(other.fits().back().result.error, apart);
  // So it is in a file, too, that has the effects alone.
  EffectStack third(base, true);
  third.restore({other.effects(), {}, {}}, how(), none_);
  EXPECT_DOUBLE_EQ(third.fits().back().result.error, apart);
  for (EffectStack* one : {&other, &third}) {
    ASSERT_TRUE(one->undo(how(), none_));
    EXPECT_TRUE(one->effects().empty());
    EXPECT_FALSE(one->undo(how(), none_));
    ASSERT_TRUE(one->redo(how(), none_));
    EXPECT_EQ(one->effects().size(), 2U);
  }
}

// Each fit has several stages: none of them starts again from nothing.
TEST_F(EffectStackTest, ProgressDoesNotFallAndStepsAreStillTold) {
  std::vector<double> shares;
  int steps = 0;
  FitObserver observer;
  observer.step = [&steps](const IterationSummary&) { ++steps; };
  const Progress progress{
      [&shares](std::string_view, double s) { shares.push_back(s); },
      {},
      std::make_shared<const FitObserver>(observer)};
  stack_->add_together({mass_at(9), mass_at(53)}, how(), progress);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  ASSERT_FALSE(shares.empty());
  EXPECT_LT(shares.front(), 0.1);
  EXPECT_GE(shares.back(), 2.0 / 3.0);  // the last of three fits
  EXPECT_GT(steps, 3);
}

TEST_F(EffectStackTest, AddsNoneOfThoseThatExcludeEachOther) {
  const auto refused = [this](const std::vector<EffectRef>& effects) {
    try {
      stack_->add_together(effects, how(), none_);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EffectRef rotary = mass_at(9);
  rotary.where.variant = "rotary";
  EXPECT_NE(refused({mass_at(9), rotary}).find("two forms"), std::string::npos);
  EXPECT_NE(refused({mass_at(9), mass_at(9)}).find("twice"), std::string::npos);
  EXPECT_NE(refused({mass_at(9), mass_at(999999)}), "");
  EXPECT_TRUE(stack_->effects().empty());
  EXPECT_FALSE(stack_->undo(how(), none_));
}

TEST_F(EffectStackTest, EveryChangeIsUndoneAndDoneAgain) {
  EXPECT_FALSE(stack_->undo(how(), none_));
  stack_->add(mass_at(9), how(), none_);
  stack_->add(mass_at(53), how(), none_);
  stack_->toggle(1, how(), none_);
  const double off = error();

  ASSERT_TRUE(stack_->undo(how(), none_));
  EXPECT_TRUE(stack_->effects()[1].on);
  EXPECT_LT(error(), 1e-4);
  ASSERT_TRUE(stack_->redo(how(), none_));
  EXPECT_FALSE(stack_->effects()[1].on);
  EXPECT_DOUBLE_EQ(error(), off);  // its fit was kept
  EXPECT_FALSE(stack_->redo(how(), none_));

  for (int k = 0; k < 3; ++k) ASSERT_TRUE(stack_->undo(how(), none_));
  EXPECT_TRUE(stack_->effects().empty());
  EXPECT_EQ(stack_->fits().size(), 1U);  // the base model as the deck has it
  ASSERT_TRUE(stack_->redo(how(), none_));
  stack_->add(mass_at(20), how(), none_);
  EXPECT_FALSE(stack_->redo(how(), none_)) << "a new branch was begun";
}

// A user who has fits end after so many steps.
Progress impatient(int steps) {
  FitObserver observer;
  observer.enough = [asked = 0, steps]() mutable { return ++asked >= steps; };
  return {{}, {}, std::make_shared<const FitObserver>(observer)};
}

TEST_F(EffectStackTest, AFitThatWasKeptComesBackAsItWas) {
  stack_->add(mass_at(9), how(), none_);
  stack_->add(mass_at(53), how(), impatient(2));
  const Fit kept = stack_->fits().back();
  EXPECT_EQ(kept.stopped_after, 2);
  EXPECT_EQ(kept.result.message.rfind("stopped early, after 2 steps", 0), 0U);
  EXPECT_FALSE(kept.result.converged);
  EXPECT_EQ(stack_->fits()[2].stopped_after, 0);
  const double reached = error();
  EXPECT_GT(reached, 1e-3) << "at its end there is nothing left";

  ASSERT_TRUE(stack_->undo(how(), none_));
  ASSERT_TRUE(stack_->redo(how(), none_));
  // The same steps: the same numbers, to the last bit.
  EXPECT_EQ(error(), reached);
  EXPECT_EQ(stack_->fits().back().stopped_after, 2);

  EffectStack other(stack_->fits().front(), true);
  other.restore(stack_->history(), how(), none_);
  EXPECT_EQ(other.fits().back().result.error, reached);
  EXPECT_EQ(other.fits().back().result.state.effects[1].p,
            kept.result.state.effects[1].p);
  EXPECT_EQ(other.history().kept, stack_->history().kept);

  stack_->toggle(0, how(), none_);
  stack_->toggle(0, how(), none_);
  EXPECT_EQ(error(), reached);
}

TEST_F(EffectStackTest, WhatWasKeptAndUndoneIsFittedToItsEndWhenAddedAnew) {
  stack_->add(mass_at(9), how(), impatient(1));
  // The fit of what is uncertain was ended, too.
  EXPECT_EQ(stack_->fits()[1].stopped_after, 1);
  EXPECT_EQ(stack_->history().kept.size(), 2U);
  const double reached = error();
  ASSERT_TRUE(stack_->undo(how(), none_));
  stack_->add(mass_at(9), how(), none_);
  EXPECT_EQ(stack_->fits().back().stopped_after, 0);
  EXPECT_TRUE(stack_->history().kept.empty());
  EXPECT_LT(error(), reached);
}

// A mass with and one without an inertia at one grid: their masses add up, and
// nothing tells how much is whose.
TEST_F(EffectStackTest, TwoFormsOfOneEffectAreRefused) {
  EffectRef rotary = mass_at(9);
  rotary.where.variant = "rotary";
  stack_->add(mass_at(9), how(), none_);
  try {
    stack_->add(rotary, how(), none_);
    ADD_FAILURE() << "both were added";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("take out added-mass at node 9,"),
              std::string::npos)
        << error.what();
  }
  // Elsewhere it may be, and in place of the other.
  rotary.where.node = 53;
  stack_->add(rotary, how(), none_);
  stack_->toggle(0, how(), none_);
  rotary.where.node = 9;
  stack_->add(rotary, how(), none_);
  EXPECT_THROW(stack_->toggle(0, how(), none_), InputError);
  EXPECT_EQ(stack_->effects().size(), 3U);
}

TEST_F(EffectStackTest, FormsThatShareNothingGoTogether) {
  StackFit quick = how();
  quick.fit = [this](const auto& effects, const Fit&, const Progress&) {
    Fit fit = stack_->fits().front();
    fit.effects = effects;
    return fit;
  };
  const auto support = [](const std::string& variant) {
    EffectRef ref{"soft-support", {}};
    ref.where.variant = variant;
    return ref;
  };
  const auto refused = [&](const std::string& variant) {
    try {
      stack_->add(support(variant), quick, none_);
      return false;
    } catch (const InputError&) {
      return true;
    }
  };
  EXPECT_FALSE(refused("rotation"));
  EXPECT_TRUE(refused("both"));
  EXPECT_TRUE(refused("rotation-varying"));
  EXPECT_FALSE(refused("translation-varying"));
  EXPECT_TRUE(refused("translation"));
}

TEST_F(EffectStackTest, AChangeThatFailsLeavesEverythingAsItWas) {
  stack_->add(mass_at(9), how(), none_);
  const double before = error();
  EXPECT_THROW(stack_->add(mass_at(9), how(), none_), InputError);
  EXPECT_THROW(stack_->add(mass_at(999), how(), none_), InputError);
  EXPECT_THROW(stack_->toggle(1, how(), none_), InputError);
  std::stop_source stopped;
  stopped.request_stop();
  Progress stop;
  stop.stop = stopped.get_token();
  EXPECT_THROW(stack_->add(mass_at(53), how(), stop), Stopped);
  EXPECT_EQ(stack_->effects().size(), 1U);
  EXPECT_DOUBLE_EQ(error(), before);
  ASSERT_TRUE(stack_->undo(how(), none_));
  EXPECT_FALSE(stack_->undo(how(), none_)) << "failures are no changes";
}

}  // namespace
}  // namespace tapfit::updating
