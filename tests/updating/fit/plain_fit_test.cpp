#include "updating/fit/plain_fit.hpp"

#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/fit/plain_updater.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace tapfit::updating {
namespace {

EffectInstance mass_at(int node, double kg) {
  Location where;
  where.node = node;
  return {&effects::find("added-mass"), where, {kg}};
}

// The deck as it is.
Fit base_of(const Fitter& fitter) {
  Fit base;
  base.model = fitter.model_for({});
  base.result.state = fitter.first_state(*base.model, {});
  return base;
}

// Without prior and damping, on the lines that errors are reported on.
PlainTask task_of(const Fitter& fitter, std::optional<double> lambda) {
  PlainTask task;
  task.options.lambda = lambda;
  task.target = fitter.target();
  task.options.properties = 1;
  task.damping_ratio = Eigen::VectorXd(4);
  task.damping_ratio << 0.006, 0.010, 0.006, 0.010;
  const Fit base = base_of(fitter);
  task.options.measured_hz =
      base.model->base_modes(base.result.state).omega.head(4) /
      (2.0 * std::numbers::pi);
  return task;
}

Fit plain(const PlateExperiment& test,
          const std::vector<EffectInstance>& start,
          std::optional<double> lambda) {
  const Fitter& fitter = test.fitter();
  return plain_fit(fitter,
                   task_of(fitter, lambda),
                   start,
                   fitter.model_for(start),
                   base_of(fitter));
}

double error_at(const Fitter& fitter,
                const FrfModel& model,
                const ModelState& state) {
  const Target& report = fitter.target();
  return relative_error(report, model.respond(state, report.s, false).H);
}

TEST(PlainFitTest, FindsWhatWasBuiltInAndTellsHow) {
  const PlateExperiment test({mass_at(30, 0.02)}, 0.01, 3);
  const Fit fit = plain(test, {mass_at(30, 0.005)}, 0.0);
  EXPECT_TRUE(fit.result.converged) << fit.result.message;
  // 1 % noise on 12 FRFs x 120 lines, of which the first mode's few count.
  EXPECT_NEAR(fit.result.state.effects[0].p[0], 0.02, 0.0006);
  EXPECT_NEAR(fit.result.state.factor[0], 1.02, 0.003);
  ASSERT_GT(fit.result.history.size(), 2U);
  // The logarithm of an exponential.
  EXPECT_NEAR((fit.result.history.back().theta - pack(fit.result.state)).norm(),
              0.0,
              1e-12);
}

TEST(PlainFitTest, SaysWhereLambdaHoldsTheParameters) {
  const PlateExperiment test({mass_at(30, 0.02)}, 0.01, 3);
  const Fit free = plain(test, {mass_at(30, 0.005)}, 0.0);
  const Fit corner = plain(test, {mass_at(30, 0.005)}, {});
  ASSERT_TRUE(corner.result.l_curve);
  EXPECT_EQ(corner.result.l_curve->lambda(corner.result.l_curve->corner),
            corner.result.history[1].lambda);
  // So large that every step is below the tolerance at once.
  const Fit held = plain(test, {mass_at(30, 0.005)}, 1e9);
  EXPECT_FALSE(held.result.converged);
  EXPECT_NE(held.result.message.find("held by lambda"), std::string::npos);
  const auto last = held.result.covariance.rows() - 1;
  EXPECT_GT(held.result.covariance(last, last),
            free.result.covariance(last, last));
}

TEST(PlainFitTest, HandsNoWorseModelOn) {
  const PlateExperiment test({mass_at(30, 0.02)}, 0.01, 3);
  const Fitter& fitter = test.fitter();
  PlainTask task;
  task.target = fitter.target();
  task.target.H *= -1.0;  // nothing that the model could be
  task.options.properties = 1;
  const Fit base = base_of(fitter);
  const Fit fit = plain_fit(fitter, task, {}, base.model, base);
  EXPECT_LE(fit.result.error, error_at(fitter, *base.model, base.result.state));
  EXPECT_FALSE(fit.result.message.empty());
  EXPECT_TRUE(fit.result.covariance.allFinite());
}

// One step is too few from the deck's own modulus, 2 % off.
TEST(PlainFitTest, GoesOnFromTheFitBefore) {
  const PlateExperiment test({mass_at(30, 0.02), mass_at(9, 3e-4)}, 1e-4, 3);
  const Fitter& fitter = test.fitter();
  const Fit before = plain(test, {mass_at(30, 0.005)}, 0.0);
  std::vector<EffectInstance> effects = before.effects;
  effects.push_back(mass_at(9, 0.005));
  PlainTask task = task_of(fitter, 0.0);
  task.options.max_iterations = 1;
  const auto model = fitter.model_for(effects);
  const Fit alone = plain_fit(fitter, task, effects, model, base_of(fitter));
  EXPECT_GT(alone.result.error, before.result.error);
  const Fit after = plain_fit(fitter, task, effects, model, before);
  EXPECT_LT(after.result.error, before.result.error);
  // The logarithm of an exponential.
  EXPECT_NEAR(after.result.history.front().theta(0),
              std::log(before.result.state.factor[0]),
              1e-12);
  EXPECT_EQ(after.result.message, "not converged in 1 steps");
}

TEST(PlainFitTest, KeepsTheModelBeforeWhereAllElseIsWorse) {
  const PlateExperiment test({mass_at(30, 0.02)}, 0.01, 3);
  const Fitter& fitter = test.fitter();
  const std::vector<EffectInstance> one = {mass_at(30, 0.005)};
  const Fit before = fitter.fit(one, fitter.model_for(one));
  std::vector<EffectInstance> effects = before.effects;
  effects.push_back(mass_at(9, 0.005));
  PlainTask task = task_of(fitter, 0.0);
  task.target.H *= -1.0;  // nothing that the model could be
  const Fit fit =
      plain_fit(fitter, task, effects, fitter.model_for(effects), before);
  EXPECT_FALSE(fit.result.converged);
  EXPECT_NE(fit.result.message.find("the model before leaves less"),
            std::string::npos)
      << fit.result.message;
  // The smallest mass there can be is not quite none, and its base is another
  // one.
  EXPECT_LT(fit.result.error, 1.001 * before.result.error);
  EXPECT_EQ(fit.result.state.factor, before.result.state.factor);
  EXPECT_EQ(fit.effects[0].p, before.effects[0].p);
  EXPECT_LT(fit.effects[1].p[0], 1e-4);
  EXPECT_TRUE(fit.result.covariance.allFinite());
}

// Half as much again as the plate weighs, the most that a mass may be.
TEST(PlainFitTest, HandsNothingOnThatNoStructureCanHave) {
  const PlateExperiment blank({}, 0.01, 3);
  const double most = blank.fitter().problem().context.mass_kg;
  const PlateExperiment test({mass_at(30, 1.5 * most)}, 0.01, 3);
  const Fitter& fitter = test.fitter();
  const std::vector<EffectInstance> start = {mass_at(30, 0.9 * most)};
  const auto model = fitter.model_for(start);
  const PlainTask task = task_of(fitter, 0.0);
  ModelState first = fitter.start_state(*model, start);
  const PlainResult beyond =
      plain_update(*model, task.target, first, task.options);
  ASSERT_GT(beyond.state.effects[0].p[0], most);
  const Fit fit = plain_fit(fitter, task, start, model, base_of(fitter));
  EXPECT_FALSE(fit.result.converged);
  EXPECT_NE(fit.result.message.find("mass_kg is"), std::string::npos)
      << fit.result.message;
  EXPECT_LE(fit.effects[0].p[0], most);
  // It is not the error that spoke against it.
  EXPECT_LT(error_at(fitter, *model, beyond.state), fit.result.error);
}

TEST(PlainFitTest, StatedIntervalsHoldTheTruth) {
  int inside = 0;
  const int trials = 40;
  for (unsigned seed = 0; seed < trials; ++seed) {
    const PlateExperiment test({mass_at(30, 0.02)}, 0.05, seed);
    const Fit fit = plain(test, {mass_at(30, 0.015)}, {});
    const auto last = fit.result.covariance.rows() - 1;
    const double sd = std::sqrt(fit.result.covariance(last, last));
    const double off = std::log(fit.result.state.effects[0].p[0] / 0.02);
    inside += std::abs(off) <= 1.96 * sd ? 1 : 0;
  }
  // 95 % of 40 is 38; 33 is the 0.5 % quantile of the binomial.
  EXPECT_GE(inside, 33);
}

}  // namespace
}  // namespace tapfit::updating
