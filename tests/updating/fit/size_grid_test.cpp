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

/// A plate with an absorber that is named without a size: where the fit ends.
/// @param after_properties whether they were fitted without it before
void expect_found(double mass_kg, double hz, bool after_properties) {
  const effects::Effect& absorber = effects::find("absorber");
  Location where;
  where.node = 25;
  where.variant = "Z";
  const PlateExperiment test(
      {{&absorber, where, {mass_kg, hz, 0.02}}}, 0.005, 5);
  const Fitter& fitter = test.fitter();
  const Fit without = fitter.fit({}, fitter.model_for({}));
  const EffectInstance named =
      placed(absorber, where, fitter.problem().context);
  const Fit fit = fitter.fit({named},
                             fitter.model_for({named}),
                             {},
                             after_properties ? &without : nullptr);
  const std::vector<double>& p = fit.result.state.effects.back().p;
  const Eigen::VectorXd sd =
      fit.result.covariance.diagonal().tail(3).cwiseSqrt();
  EXPECT_LT(std::abs(std::log(p[0] / mass_kg)), 3.0 * sd(0)) << hz;
  EXPECT_LT(std::abs(std::log(p[1] / hz)), 3.0 * sd(1)) << hz;
  EXPECT_LT(sd(0), 0.2) << hz;
}

// Wherever in the band it is tuned. One parameter after the other the fit ended
// with the least mass that there may be, in the middle of the band.
TEST(FitStart, FindsAResonanceWhereverItIsTuned) {
  for (const double hz : {210.0, 260.0, 350.0}) expect_found(0.01, hz, false);
}

// A light one on a plate whose modulus is 2 % off: seen from the deck's modulus
// other things are larger, and a fit from there ends at the band's lower end.
TEST(FitStart, FindsALightResonanceBesideAModulusThatIsOff) {
  for (const double hz : {210.0, 260.0, 350.0}) expect_found(0.003, hz, true);
}

}  // namespace
}  // namespace tapfit::updating
