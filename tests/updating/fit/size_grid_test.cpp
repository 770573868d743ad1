#include "updating/fit/size_grid.hpp"

#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

// In the middle of equal parts of the logarithm.
TEST(SizeGrid, IsEveryCombinationOfSizesBetweenTheBounds) {
  const std::vector<effects::ParameterSpec> specs = {
      {"mass_kg", 1.0, 1e-2, 1e2}, {"damping_ratio", 0.02, 1e-3, 1e-1}};
  const auto grid = size_grid(specs, {2, 1});
  ASSERT_EQ(grid.size(), 2U);
  EXPECT_NEAR(grid[0][0], 0.1, 1e-12);
  EXPECT_NEAR(grid[1][0], 10.0, 1e-12);
  for (const std::vector<double>& p : grid) EXPECT_NEAR(p[1], 0.01, 1e-12);
  EXPECT_EQ(size_grid(specs).size(), 8U * 4U);
}

// An absorber that is named without a size: wherever in the band it is tuned,
// the fit ends there. One parameter after the other it ended with the least
// mass that there may be, in the middle of the band.
TEST(FitStart, FindsAResonanceWhereverItIsTuned) {
  const effects::Effect& absorber = effects::find("absorber");
  Location where;
  where.node = 25;
  where.variant = "Z";
  for (const double hz : {210.0, 260.0, 350.0}) {
    const PlateExperiment test(
        {{&absorber, where, {0.01, hz, 0.02}}}, 0.005, 5);
    const Fitter& fitter = test.fitter();
    const EffectInstance named =
        placed(absorber, where, fitter.problem().context);
    const Fit fit = fitter.fit({named}, fitter.model_for({named}));
    const std::vector<double>& p = fit.result.state.effects.back().p;
    const Eigen::VectorXd sd =
        fit.result.covariance.diagonal().tail(3).cwiseSqrt();
    EXPECT_LT(std::abs(std::log(p[0] / 0.01)), 3.0 * sd(0)) << hz;
    EXPECT_LT(std::abs(std::log(p[1] / hz)), 3.0 * sd(1)) << hz;
    EXPECT_LT(sd(0), 0.2) << hz;
  }
}

// A light one on a plate whose modulus is 2 % off: seen from the deck's modulus
// other things are larger, and a fit from there ends at the band's lower end.
TEST(FitStart, FindsALightResonanceBesideAModulusThatIsOff) {
  const effects::Effect& absorber = effects::find("absorber");
  Location where;
  where.node = 25;
  where.variant = "Z";
  for (const double hz : {210.0, 260.0, 350.0}) {
    const PlateExperiment test(
        {{&absorber, where, {0.003, hz, 0.02}}}, 0.005, 5);
    const Fitter& fitter = test.fitter();
    const Fit without = fitter.fit({}, fitter.model_for({}));
    const EffectInstance named =
        placed(absorber, where, fitter.problem().context);
    const Fit fit =
        fitter.fit({named}, fitter.model_for({named}), {}, &without);
    const std::vector<double>& p = fit.result.state.effects.back().p;
    const Eigen::VectorXd sd =
        fit.result.covariance.diagonal().tail(3).cwiseSqrt();
    EXPECT_LT(std::abs(std::log(p[0] / 0.003)), 3.0 * sd(0)) << hz;
    EXPECT_LT(std::abs(std::log(p[1] / hz)), 3.0 * sd(1)) << hz;
    EXPECT_LT(sd(0), 0.2) << hz;
  }
}

}  // namespace
}  // namespace tapfit::updating
