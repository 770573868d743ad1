// Intervals where the FRFs come without a variance.
#include "modal/identify/identify_modes.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace tapfit {
namespace {

// Resonances of a few lines are no noise: intervals stay as wide as the errors.
TEST(Intervals, HoldWithoutAVariance) {
  for (const double noise : {0.001, 0.01}) {
    double sum = 0.0;
    int count = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
      std::mt19937_64 random(seed);
      const test::SyntheticSystem system =
          test::random_system(5, 12, 0.01, 0.01, random);
      signal::FrfSet frfs = test::roving_hammer(
          system, {3, 5}, test::line_points(8, 100, 400, 0.0), noise, random);
      for (signal::Frf& frf : frfs.frfs) {
        frf.variance.resize(0);
        frf.hits = 1;
      }
      const modal::ModeSet set = modal::identify_modes(frfs, {});
      ASSERT_EQ(set.modes.size(), 5U) << seed;
      for (Eigen::Index r = 0; r < 5; ++r) {
        const modal::Mode& mode = set.modes[static_cast<std::size_t>(r)];
        sum += std::pow(
            (mode.frequency_hz - system.frequency_hz(r)) / mode.frequency_sd_hz,
            2);
        sum += std::pow((mode.damping_ratio - 0.01) / mode.damping_sd, 2);
        count += 2;
      }
    }
    // Of 80 errors over their deviations; 0.22 to 0.63 where the curvature of
    // the FRFs is taken for noise.
    const double pull = std::sqrt(sum / count);
    EXPECT_GT(pull, 0.7) << noise;
    EXPECT_LT(pull, 1.4) << noise;
  }
}

// Blows that scatter leave noise in proportion to the FRF. Of resonances
// narrower than the step from line to line what is left beside the peak is a
// tenth of the noise that matters: 44 % of such intervals held by that.
TEST(Intervals, HoldForSharpResonancesWhoseNoiseGoesWithTheFrf) {
  int held = 0;
  int count = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 0.01 / std::sqrt(2.0));
    const test::SyntheticSystem system =
        test::random_system(5, 12, 5e-4, 5e-4, random);
    signal::FrfSet frfs = test::roving_hammer(
        system, {3, 5}, test::line_points(8, 100, 737, 0.0), 0.0, random);
    for (signal::Frf& frf : frfs.frfs) {
      frf.variance.resize(0);
      frf.hits = 1;
      for (std::complex<double>& value : frf.H) {
        value *= std::complex<double>(1.0 + normal(random), normal(random));
      }
    }
    const modal::ModeSet set = modal::identify_modes(frfs, {});
    ASSERT_EQ(set.modes.size(), 5U) << seed;
    for (Eigen::Index r = 0; r < 5; ++r) {
      const modal::Mode& mode = set.modes[static_cast<std::size_t>(r)];
      const double f = mode.frequency_hz - system.frequency_hz(r);
      const double zeta = mode.damping_ratio - 5e-4;
      held += std::abs(f) < 1.96 * mode.frequency_sd_hz ? 1 : 0;
      held += std::abs(zeta) < 1.96 * mode.damping_sd ? 1 : 0;
      count += 2;
    }
  }
  // 95 of 100 in the mean; of 120 no fewer than 88 % by chance.
  EXPECT_GE(held, 0.88 * count) << count;
}

}  // namespace
}  // namespace tapfit
