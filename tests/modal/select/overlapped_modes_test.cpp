#include "modal/identify/identify_modes.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tapfit {
namespace {

using Eigen::Index;

/// Modes in equal steps from 20 Hz, with shapes at 14 points.
test::SyntheticSystem even_system(Index modes,
                                  double last_hz,
                                  double damping_ratio,
                                  std::mt19937_64& random) {
  return {Eigen::VectorXd::LinSpaced(modes, 20.0, last_hz),
          Eigen::VectorXd::Constant(modes, damping_ratio),
          test::random_shapes(14, modes, random)};
}

// Eight modes from 20 to 183 Hz, 10 % damped: from the third on each resonance
// is wider than the step to the next. Smooth shapes, two references, noise of
// 5 % of every value: no order's poles last, and nothing left has a peak.
TEST(OverlappedModes, AreFoundUnderNoise) {
  std::mt19937_64 random(4);
  const test::SyntheticSystem system = even_system(8, 183.1, 0.1, random);
  for (int seed = 0; seed < 3; ++seed) {
    const modal::ModeSet set = modal::identify_modes(
        test::roving_hammer(system,
                            {0, 5},
                            test::line_points(5.0, 205.0, 1601, 0.0),
                            0.05,
                            random),
        {});
    ASSERT_EQ(set.modes.size(), 8U) << seed;
    for (Index r = 0; r < 8; ++r) {
      const modal::Mode& mode = set.modes[static_cast<std::size_t>(r)];
      // As far as such noise lets one know: about three deviations.
      EXPECT_NEAR(mode.frequency_hz / system.frequency_hz(r), 1.0, 0.01);
      EXPECT_NEAR(mode.damping_ratio, 0.1, 0.01) << mode.frequency_hz;
    }
  }
}

// A mode of which 75 dB less shows than of its neighbours, told only by what a
// fit without it leaves.
TEST(FaintModes, StayWhereTheFrfsNeedThem) {
  std::mt19937_64 random(5);
  test::SyntheticSystem system = even_system(5, 113.2, 0.01, random);
  system.phi.col(2) *= std::pow(10.0, -75.0 / 40.0);
  const modal::ModeSet set = modal::identify_modes(
      test::roving_hammer(system,
                          {0, 5},
                          test::line_points(5.0, 135.0, 1041, 0.0),
                          1e-6,
                          random),
      {});
  ASSERT_EQ(set.modes.size(), 5U);
  EXPECT_NEAR(set.modes[2].frequency_hz, system.frequency_hz(2), 0.01);
}

}  // namespace
}  // namespace tapfit
