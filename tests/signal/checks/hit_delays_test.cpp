#include "signal/checks/hit_delays.hpp"

#include "signal/checks/delay_steps.hpp"
#include "tests/signal/support/generated_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tapfit::signal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double sample_s = 1.0 / 512.0;
constexpr double noise = 0.05;  // rms of |dH|, where |H| is about 1

// 400 lines of 5 to 105 Hz on a damped line, noise of the same size on all.
HitFrfs made_frfs(const VectorXd& delays,
                  const std::vector<double>& stretch,
                  unsigned seed) {
  const std::vector<TestMode> modes{
      {18.0, 0.01, 1.0}, {47.0, 0.008, -0.7}, {88.0, 0.01, 0.9}};
  HitFrfs of;
  of.omega = VectorXd::LinSpaced(
      400, 2.0 * std::numbers::pi * 5.0, 2.0 * std::numbers::pi * 105.0);
  of.H.resize(400, delays.size());
  of.variance.setConstant(400, delays.size(), noise * noise);
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> part(0.0, noise / std::sqrt(2.0));
  for (Index k = 0; k < delays.size(); ++k) {
    const double of_hit = stretch[static_cast<std::size_t>(k)];
    for (Index l = 0; l < 400; ++l) {
      const double w = of.omega(l);
      of.H(l, k) = exact_frf(modes, {2.0, w / of_hit}) *
                       std::polar(1.0, -w * delays(k)) +
                   std::complex<double>(part(engine), part(engine));
    }
  }
  return of;
}

HitDelayOptions closely() {
  return {.most_s = 64.0 * sample_s, .slight_s = 0.0};
}

// The definition, and the bound of Cramer and Rao for its deviation:
// 1 / var = 2 sum omega^2 |R|^2 / noise^2 for one hit.
TEST(HitDelays, AreThoseThatWereMade) {
  const VectorXd delays =
      sample_s * (VectorXd(5) << 0.0, 0.2, -3.0, 1.0, 21.5).finished();
  const HitFrfs of = made_frfs(delays, {1, 1, 1, 1, 1}, 4);
  const HitDelays found = hit_delays(of, closely());
  const HitFrfs exact = made_frfs(VectorXd::Zero(1), {1}, 4);
  const double bound =
      noise /
      std::sqrt(2.0 * exact.H.col(0).cwiseAbs2().dot(exact.omega.cwiseAbs2()));
  const VectorXd expected = delays.array() - delays.mean();
  for (Index k = 0; k < delays.size(); ++k) {
    // 4 of 5 normal deviations; the deviation is one of 800 squares.
    EXPECT_NEAR(found.delay_s(k), expected(k), 4.0 * bound) << k;
    EXPECT_NEAR(found.sd_s(k), bound, 0.15 * bound) << k;
  }
  EXPECT_NEAR(found.after / found.expected, 1.0, 0.1);
}

TEST(HitDelays, AreNotLookedForWhereHitsAgree) {
  const HitFrfs of = made_frfs(VectorXd::Zero(4), {1, 1, 1, 1}, 5);
  HitDelayOptions options = closely();
  options.slight_s = 0.05 * sample_s;
  const HitDelays found = hit_delays(of, options);
  EXPECT_EQ(found.sd_s.size(), 0);
  EXPECT_EQ(found.delay_s, VectorXd::Zero(4));
}

DelayHistory history_of(const VectorXd& delays,
                        const std::vector<double>& stretch,
                        unsigned seed) {
  const VectorXd times = VectorXd::LinSpaced(
      delays.size(), 0.0, 8.0 * static_cast<double>(delays.size()));
  return delay_history(
      hit_delays(made_frfs(delays, stretch, seed), closely()), times, sample_s);
}

TEST(DelayHistory, PartsHitsWhereTheirDelayChanges) {
  const VectorXd delays =
      sample_s * (VectorXd(7) << 0, 0, 2, 2, 2, -0.5, -0.5).finished();
  const DelayHistory found = history_of(delays, {1, 1, 1, 1, 1, 1, 1}, 6);
  EXPECT_FALSE(found.drift);
  ASSERT_EQ(found.steps.size(), 2U);
  EXPECT_EQ(found.steps[0].first, 2);
  EXPECT_EQ(found.steps[1].first, 5);
}

TEST(DelayHistory, TellsADriftFromSteps) {
  const VectorXd delays = sample_s * VectorXd::LinSpaced(6, 0.0, 1.5);
  const DelayHistory found = history_of(delays, {1, 1, 1, 1, 1, 1}, 7);
  EXPECT_TRUE(found.steps.empty());
  ASSERT_TRUE(found.drift);
  EXPECT_NEAR(found.drift->delay_s, 1.5 * sample_s, 5.0 * found.drift->sd_s);
  EXPECT_LT(found.drift->sd_s, 0.05 * sample_s);
}

// Frequencies that fall by up to 3 % turn phases, near resonances only.
TEST(DelayHistory, IsEmptyForAStructureThatChanges) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    for (const double fall : {0.0005, 0.002, 0.006}) {
      std::vector<double> evenly;
      std::vector<double> at_once;
      for (int k = 0; k < 6; ++k) {
        evenly.push_back(1.0 - fall * k);
        at_once.push_back(k < 3 ? 1.0 : 1.0 - 5.0 * fall);
      }
      for (const auto& stretch : {evenly, at_once}) {
        const DelayHistory found = history_of(VectorXd::Zero(6), stretch, seed);
        EXPECT_FALSE(found.drift) << seed << " " << fall;
        EXPECT_TRUE(found.steps.empty()) << seed << " " << fall;
      }
    }
  }
}

}  // namespace
}  // namespace tapfit::signal
