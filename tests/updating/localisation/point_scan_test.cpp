#include "updating/localisation/point_scan.hpp"

#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

Location point(const std::string& channel, int written, int real) {
  Location where;
  where.channels = {channel};
  where.nodes = {written};
  where.node = real;
  return where;
}

// What is left once the point is put right, the rest as the scan has it: the
// scan must foretell it for the very state it starts from.
TEST(PointScan, IsTheErrorOfTheFrfsOfThatGrid) {
  const effects::Effect& mistake = effects::find("point-mislabelled");
  const PlateExperiment test({{&mistake, point("hammer", 52, 49), {}}}, 0.0, 1);
  const Fitter& fitter = test.fitter();
  Fit fit = fitter.fit({}, fitter.model_for({}));
  fit.model = fitter.model_for({}, BaseUse::Scan);
  const Target& target = fitter.target();
  const ProjectedMisfit misfit(fit, target);
  const std::vector<PointElsewhere> found =
      PointScan(fit, target, misfit, fitter.problem().measured)
          .elsewhere(mistake.places(fitter.problem().context));
  ASSERT_FALSE(found.empty());
  const auto best = std::ranges::min_element(
      found, {}, [](const PointElsewhere& p) { return p.error; });
  EXPECT_EQ(best->where, point("hammer", 52, 49));
  // Without noise nothing is left but what does not readjust to first order.
  EXPECT_LT(best->error, 0.2 * fit.result.error);
}

TEST(PointScan, LeavesPointsAloneThatHaveNothingToAnswerFor) {
  const effects::Effect& mistake = effects::find("point-mislabelled");
  const PlateExperiment test({{&mistake, point("hammer", 52, 49), {}}}, 0.0, 1);
  const Fitter& fitter = test.fitter();
  Fit fit = fitter.fit({}, fitter.model_for({}));
  fit.model = fitter.model_for({}, BaseUse::Scan);
  PointScanOptions options;
  options.least_share = 0.3;
  options.grids = 4;
  const ProjectedMisfit misfit(fit, fitter.target());
  const std::vector<PointElsewhere> found =
      PointScan(fit, fitter.target(), misfit, fitter.problem().measured)
          .elsewhere({point("hammer", 52, 0), point("hammer", 6, 0)}, options);
  ASSERT_EQ(found.size(), 4U);
  for (const PointElsewhere& there : found) {
    EXPECT_EQ(there.where.nodes, std::vector{52});
  }
}

// Both ways to the same number: FRFs of other ends, and the model's own answer.
TEST(PointScan, ForetellsWhatTheModelAnswersWithoutTheMistake) {
  const PlateExperiment test({}, 0.01, 1);
  const Fitter& fitter = test.fitter();
  Fit fit = fitter.fit({}, fitter.model_for({}));
  fit.model = fitter.model_for({}, BaseUse::Scan);
  const Target& target = fitter.target();
  const ProjectedMisfit misfit(fit, target);
  const PointScan scan(fit, target, misfit, fitter.problem().measured);
  const Eigen::MatrixXcd now =
      fit.model->respond(fit.result.state, target.s, false).H;
  for (const char* name :
       {"channel-swap", "channel-polarity", "direction-wrong"}) {
    const effects::Effect& effect = effects::find(name);
    for (const Location& where : effect.places(fitter.problem().context)) {
      const EffectInstance mistake{&effect, where, {}};
      ModelState state = fit.result.state;
      state.effects.push_back(mistake);
      const Eigen::MatrixXcd H = fit.model->respond(state, target.s, false).H;
      const Eigen::MatrixXd change = misfit.change(H - now);
      const double expected = misfit.errors(change)(0);
      EXPECT_NEAR(scan.error_without(mistake), expected, 1e-9 * expected)
          << name << " at " << describe(where);
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
