#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/residual/independent_data.hpp"
#include "updating/search/reach.hpp"
#include "updating/search/worth_fitting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

EffectInstance at_grid(const Fitter& fitter,
                       const std::string& name,
                       int node) {
  Location where;
  where.node = node;
  where.variant = "Z";
  return placed(effects::find(name), where, fitter.problem().context);
}

// A mass of 50 g that the deck lacks, looked for as itself, beside where it is,
// and as two things that it is not.
class Approach : public ::testing::Test {
 protected:
  Approach() {
    Location where;
    where.node = 25;
    hidden_ = {{&effects::find("added-mass"), where, {0.05}}};
    test_.emplace(hidden_, 0.005, 5);
    const Fitter& fitter = test_->fitter();
    for (const int node : {25, 27}) {
      where.node = node;
      tries_.push_back(
          placed(effects::find("added-mass"), where, fitter.problem().context));
    }
    tries_.push_back(at_grid(fitter, "absorber", 25));
    tries_.push_back(at_grid(fitter, "dashpot", 25));
  }
  std::vector<EffectInstance> hidden_;
  std::optional<PlateExperiment> test_;
  std::vector<EffectInstance> tries_;
};

// The end leaves no more, and is not likelier by what hypotheses are dropped
// for (30 of a log likelihood). An absorber, which begins far off, is the
// farthest.
TEST_F(Approach, TellsHowLikelyTheEndIs) {
  const Fitter& fitter = test_->fitter();
  for (const EffectInstance& effect : tries_) {
    const Fit begun =
        fitter.approach({effect}, fitter.model_for({effect})).value();
    const Fit end = fitter.arrive(begun);
    const bool far = effect.effect->name() == "absorber";
    EXPECT_NEAR(begun.log_likelihood, end.log_likelihood, far ? 25.0 : 1.0)
        << effect.effect->name() << " at " << effect.where.node;
    EXPECT_LE(end.result.error, begun.result.error * (1.0 + 1e-9));
  }
}

TEST_F(Approach, AndArrivalEndWhereAFitDoes) {
  const Fitter& fitter = test_->fitter();
  for (const EffectInstance& effect : tries_) {
    const auto model = fitter.model_for({effect});
    const Fit whole = fitter.fit({effect}, model);
    const Fit parted = fitter.arrive(fitter.approach({effect}, model).value());
    const Eigen::VectorXd sd = whole.result.covariance.diagonal().cwiseSqrt();
    const Eigen::VectorXd off =
        (pack(parted.result.state) - pack(whole.result.state)).cwiseAbs();
    EXPECT_LE((off.array() / sd.array()).maxCoeff(), 0.1)
        << effect.effect->name() << " at " << effect.where.node;
  }
}

// Both ends are within what fits notice of the higher modes' damping.
TEST_F(Approach, SettledEndsAtOneErrorFromEitherSide) {
  const Fitter& fitter = test_->fitter();
  const auto model = fitter.model_for(hidden_);
  std::vector<double> ended;
  std::vector<double> settled;
  for (const double factor : {0.93, 1.07}) {
    Fit fit = fitter.fit(hidden_, model);
    fit.result.state.zeta_other =
        factor * fitter.settled(fit).result.state.zeta_other;
    fit = fitter.fit_beside(fit, hidden_, model);
    ended.push_back(fit.result.error);
    settled.push_back(fitter.settled(fit).result.error);
  }
  EXPECT_NEAR(settled[0], settled[1], 1e-3 * settled[0]);
  EXPECT_GT(std::abs(ended[0] - ended[1]), 1e-3 * ended[0]);
}

// What is given up on the wide lines ends out of reach of what is known.
TEST_F(Approach, IsGivenUpWhereWhatIsKnownStaysFarAhead) {
  const Fitter& fitter = test_->fitter();
  const Fit none = fitter.fit({}, fitter.model_for({}));
  Reach reach(none, fitter);
  EXPECT_EQ(reach.hopeless_wide_error(),
            std::numeric_limits<double>::infinity());
  const EffectInstance& right = tries_.front();
  reach.take_known(fitter.fit({right}, fitter.model_for({right})), fitter);
  int given_up = 0;
  for (const EffectInstance& effect : tries_) {
    const auto model = fitter.model_for({effect});
    const std::optional<Fit> begun =
        fitter.approach({effect}, model, {}, reach.hopeless_wide_error());
    if (begun) continue;
    ++given_up;
    EXPECT_TRUE(reach.is_hopeless(reach.judged(fitter.fit({effect}, model))))
        << effect.effect->name() << " at " << effect.where.node;
  }
  EXPECT_GE(given_up, 1);
  EXPECT_TRUE(fitter.approach(
      {right}, fitter.model_for({right}), {}, reach.hopeless_wide_error()));
}

// Nor is begun what the screening sees farther behind than it may be wrong.
TEST_F(Approach, IsNotTriedWhereTheScreeningLeavesFarMore) {
  const Fitter& fitter = test_->fitter();
  const Fit none = fitter.fit({}, fitter.model_for({}));
  const EffectInstance& right = tries_.front();
  Reach reach(none, fitter);
  reach.take_known(fitter.fit({right}, fitter.model_for({right})), fitter);
  const auto tried = [&](double screened_error) {
    std::size_t count = 0;
    for (const Planned& plan :
         planned_fits(none, {{right, screened_error}}, fitter, {}, reach)) {
      if (plan.effect == right.effect) count += plan.tries.size();
    }
    return count;
  };
  EXPECT_EQ(tried(0.9 * reach.hopeless_screened_error()), 1U);
  EXPECT_EQ(tried(1.1 * reach.hopeless_screened_error()), 0U);
}

// Fits of more or fewer modes are compared: one count of data is for all.
TEST_F(Approach, IsJudgedByTheDataWhateverItsModes) {
  const Fitter& fitter = test_->fitter();
  const Target& target = fitter.target();
  const Fit fit = fitter.fit({}, fitter.model_for({}));
  ASSERT_NE(fit.result.state.zeta.size(), target.modes_in_band);
  const FormEstimate form =
      estimate_form(fit.form, most_data(target), noise_error(target));
  EXPECT_DOUBLE_EQ(fit.log_likelihood, form.log_likelihood);
}

}  // namespace
}  // namespace tapfit::updating
