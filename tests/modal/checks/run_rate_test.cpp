#include "modal/checks/run_rate.hpp"

#include "modal/checks/frfs_by_run.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

/// One run of a plate with six modes in the band, its time axis stretched.
class RunRate : public ::testing::Test {
 protected:
  RunRate() : system_(test::random_system(6, 4, 0.005, 0.015, random_)) {}

  /// @param ratio on all frequencies
  [[nodiscard]] signal::FrfSet run_at(double ratio) {
    test::SyntheticSystem stretched = system_;
    stretched.frequency_hz *= ratio;
    return test::roving_hammer(stretched,
                               {0, 1},
                               test::line_points(5.0, 100.0, 951, 0.2),
                               0.01,
                               random_);
  }

  [[nodiscard]] VectorXcd poles() const {
    const Index in_band = system_.frequency_hz.size() - 2;
    VectorXcd poles(in_band);
    for (Index k = 0; k < in_band; ++k) {
      const double w = 2.0 * std::numbers::pi * system_.frequency_hz(k);
      const double zeta = system_.damping_ratio(k);
      poles(k) = {-zeta * w, w * std::sqrt(1.0 - zeta * zeta)};
    }
    return poles;
  }

  std::mt19937_64 random_{11};
  test::SyntheticSystem system_;
};

TEST_F(RunRate, RatiosAreOfTwoRatesEach) {
  const std::vector<double> ratios = rate_ratios();
  EXPECT_TRUE(std::ranges::is_sorted(ratios));
  for (const double known : {0.5, 2.0, 51.2 / 50.0, 44.1 / 48.0}) {
    EXPECT_TRUE(std::ranges::any_of(ratios, [known](double ratio) {
      return std::abs(ratio / known - 1.0) < 1e-9;
    })) << known;
    EXPECT_GE(known, ratios.front());
    EXPECT_LE(known, ratios.back());
  }
  EXPECT_TRUE(std::ranges::none_of(
      ratios, [](double ratio) { return std::abs(ratio - 1.0) < 1e-3; }));
}

TEST_F(RunRate, IsFoundWhereAllFrequenciesAreByOneRatioOff) {
  for (const double ratio : {0.5, 50.0 / 51.2, 51.2 / 50.0, 48.0 / 44.1}) {
    const auto found = rate_ratio(run_at(ratio), poles(), 0.01);
    ASSERT_TRUE(found) << ratio;
    EXPECT_NEAR(*found, ratio, 1e-9);
  }
}

// Neither as it is, nor warmer, nor with a mass on it that moves mode by mode.
TEST_F(RunRate, IsNotFoundInAnotherState) {
  EXPECT_FALSE(rate_ratio(run_at(1.0), poles(), 0.01));
  EXPECT_FALSE(rate_ratio(run_at(0.985), poles(), 0.01));
  const Eigen::VectorXd before = system_.frequency_hz;
  for (Index k = 0; k < before.size(); ++k) {
    system_.frequency_hz(k) = before(k) * (1.0 - 0.01 * static_cast<double>(k));
  }
  const signal::FrfSet loaded = run_at(1.0);
  system_.frequency_hz = before;
  EXPECT_FALSE(rate_ratio(loaded, poles(), 0.01));
}

// Of one mode in the band any other structure's is about a ratio of two rates.
TEST_F(RunRate, IsNotToldByFewModes) {
  system_ = test::random_system(1, 4, 0.005, 0.015, random_);
  const signal::FrfSet run = run_at(51.2 / 50.0);
  EXPECT_FALSE(rate_ratio(run, poles(), 0.01));
  RunRateLimits one;
  one.fewest_modes = 1;
  EXPECT_TRUE(rate_ratio(run, poles(), 0.01, one));
}

}  // namespace
}  // namespace tapfit::modal
