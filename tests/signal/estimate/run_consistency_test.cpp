#include "signal/estimate/run_consistency.hpp"

#include "signal/spectra/spectra.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace tapfit::signal {
namespace {

constexpr int lines = 80;

// Two modes at each of two sensors, shifted in frequency by a share.
std::complex<double> frf(std::size_t sensor, double hz, double shift) {
  std::complex<double> H = 0.0;
  for (const double f0 : {20.0, 60.0}) {
    const double f = f0 * (1.0 + shift);
    const double gain = sensor == 1 && f0 > 30.0 ? -0.6 : 1.0;
    H += gain * hz * hz /
         (f * f - hz * hz + std::complex<double>(0.0, 0.02 * f * hz));
  }
  return H;
}

struct Made {
  Spectra spectra;
  std::vector<std::size_t> run;
};

// Hits that repeat to 2 % (their place) in noise of 1 %; gain and shift as
// given of each.
template <typename Gain, typename Shift>
Made test_of(
    std::size_t runs, int each, unsigned seed, Gain gain, Shift shift) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Made test;
  const auto hits = static_cast<Eigen::Index>(runs) * each;
  test.spectra.force.resize(lines, hits);
  test.spectra.responses.assign(2, Eigen::MatrixXcd(lines, hits));
  for (Eigen::Index k = 0; k < hits; ++k) {
    const auto r = static_cast<std::size_t>(k / each);
    test.run.push_back(r);
    const double level = 10.0 + 3.0 * std::abs(normal(random));
    const std::array place{0.02 * normal(random), 0.02 * normal(random)};
    for (Eigen::Index l = 0; l < lines; ++l) {
      const double hz = 1.0 + static_cast<double>(l);
      test.spectra.force(l, k) = level;
      for (std::size_t c = 0; c < 2; ++c) {
        const std::complex<double> noise(normal(random), normal(random));
        test.spectra.responses[c](l, k) =
            level * (gain(r, c) * (1.0 + place[c]) * frf(c, hz, shift(r)) +
                     0.01 * noise);
      }
    }
  }
  return test;
}

std::optional<RunInconsistency> difference_of(const Made& test) {
  std::vector<RunPowers> runs;
  for (std::size_t k = 0; k < test.run.size(); ++k) {
    if (runs.empty() || runs.back().place != test.run[k]) {
      runs.push_back({test.run[k], std::vector<CrossPowers>(2)});
    }
    const auto column = static_cast<Eigen::Index>(k);
    for (std::size_t c = 0; c < 2; ++c) {
      runs.back().powers[c] +=
          cross_powers(test.spectra.force.col(column),
                       test.spectra.responses[c].col(column));
    }
  }
  return run_inconsistency(runs);
}

double no_gain(std::size_t /*run*/, std::size_t /*sensor*/) { return 1.0; }
double no_shift(std::size_t /*run*/) { return 0.0; }

// Promised: 1 in 500; 400 tests, so 4 and more would be chance of 1 in 100.
TEST(RunInconsistency, IsNotSeenWhereRunsAgree) {
  int false_alarms = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    for (const auto& [runs, each] : {std::pair{5U, 1}, {3U, 4}}) {
      const Made test = test_of(runs, each, seed, no_gain, no_shift);
      false_alarms += difference_of(test) ? 1 : 0;
    }
  }
  EXPECT_LE(false_alarms, 3);
}

TEST(RunInconsistency, NamesTheRunWhoseRangeWasChanged) {
  const auto gain = [](std::size_t run, std::size_t sensor) {
    return run == 2 && sensor == 1 ? 1.5 : 1.0;
  };
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Made test = test_of(4, 4, seed, gain, no_shift);
    const auto found = difference_of(test);
    ASSERT_TRUE(found) << "seed " << seed;
    EXPECT_EQ(found->run, 2U);
    EXPECT_EQ(found->sensor, 1U);
    ASSERT_TRUE(found->factor);
    // Four hits that repeat to 2 % against twelve: 1.2 %, five times that.
    EXPECT_NEAR(*found->factor, 1.5, 0.09);
  }
}

// Nothing but single hits: one that is four times as far away as five hits of
// 2 % ever were is said to be.
TEST(RunInconsistency, NamesASingleHitThatStandsApart) {
  const auto gain = [](std::size_t run, std::size_t /*sensor*/) {
    return run == 4 ? 3.0 : 1.0;
  };
  int found = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Made test = test_of(6, 1, seed, gain, no_shift);
    const auto difference = difference_of(test);
    if (!difference) continue;
    ++found;
    EXPECT_EQ(difference->kind, RunInconsistency::Kind::OneApart);
    EXPECT_EQ(difference->run, 4U);
    ASSERT_TRUE(difference->factor);
    EXPECT_NEAR(*difference->factor, 3.0, 0.3);
  }
  EXPECT_EQ(found, 20);
}

// Half a per cent over six files, at 1 % damping a quarter of a bandwidth.
TEST(RunInconsistency, SeesAStructureThatWarmsUp) {
  const auto shift = [](std::size_t run) {
    return -0.001 * static_cast<double>(run);
  };
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Made test = test_of(6, 3, seed, no_gain, shift);
    const auto found = difference_of(test);
    ASSERT_TRUE(found) << "seed " << seed;
    EXPECT_NE(found->kind, RunInconsistency::Kind::OneApart);
    EXPECT_FALSE(found->factor);
  }
}

// The point that is hit again at the end: two runs.
TEST(RunInconsistency, ComparesTwoRuns) {
  const auto shift = [](std::size_t run) { return run == 1 ? 0.01 : 0.0; };
  const Made test = test_of(2, 5, 1, no_gain, shift);
  EXPECT_TRUE(difference_of(test));
}

TEST(RunInconsistency, NeedsTwoRunsAndThreeHits) {
  const Made one = test_of(1, 6, 1, no_gain, no_shift);
  EXPECT_FALSE(difference_of(one));
  const Made two = test_of(2, 1, 1, no_gain, no_shift);
  EXPECT_FALSE(difference_of(two));
}

TEST(RunInconsistency, IsSaidInWords) {
  acquisition::TestBundle bundle;
  bundle.channels.resize(2);
  bundle.channels[1].name = "acc1";
  bundle.runs.resize(3);
  for (acquisition::Run& run : bundle.runs) run.sensors = {{1, {}}};
  bundle.runs[2].file = "third.wav";
  RunInconsistency found;
  found.kind = RunInconsistency::Kind::OneApart;
  found.change = 0.5;
  found.run = 1;
  found.factor = 1.5;
  const Finding said = finding_of(found, bundle, {0, 2});
  EXPECT_EQ(in_full(said),
            "runs 1 and 3 measured the same and are averaged together, but run "
            "3 (third.wav) differs from the others by about 50 %, acc1 by a "
            "factor of 1.5 and nothing else: a range or a sensitivity was "
            "changed; leave out the runs at fault");
  EXPECT_EQ(said.where.runs, std::vector<std::size_t>{2});
  EXPECT_EQ(said.where.channel, "acc1");
}

}  // namespace
}  // namespace tapfit::signal
