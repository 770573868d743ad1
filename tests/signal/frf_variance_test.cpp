#include "signal/frf_variance.hpp"

#include "tests/signal/band_coverage.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::signal {
namespace {

const std::vector<TestMode> two_modes{{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}};

// Promised: 93 to 97 % of the truths in 95 % bands. Forty records of 140 to
// 750 lines, of which about one in three is independent, leave 0.5 % of chance.
void expect_covered(const Coverage& c) {
  fmt::print("covered: {:.1f} %\n", 100.0 * c.share);
  EXPECT_GT(c.share, 0.93);
  EXPECT_LT(c.share, 0.97);
}

TEST(FrfVariance, CoversForOneHit) {
  const Coverage c = coverage(two_modes, noisy(1), false, 40);
  expect_covered(c);
  expect_covered(coverage(two_modes, noisy(1), true, 60));
}

TEST(FrfVariance, CoversForTwoHits) {
  expect_covered(coverage(two_modes, noisy(2), false, 40));
}

TEST(FrfVariance, CoversForThreeHitsOnFftLines) {
  const Coverage c = coverage(two_modes, noisy(3), false, 40);
  expect_covered(c);
  // H1 is unbiased with noise on the response; the force's noise biases it by
  // Nf / |F|^2, 1e-5 here. The mean over 30,000 lines scatters by 1e-4.
  EXPECT_LT(c.bias, 5e-4);
}

TEST(FrfVariance, CoversForThreeHitsOnADampedLine) {
  expect_covered(coverage(two_modes, noisy(3), true, 60));
}

TEST(FrfVariance, CoversForFiveHits) {
  expect_covered(coverage(two_modes, noisy(5), false, 30));
}

TEST(FrfVariance, CoversForTenHits) {
  expect_covered(coverage(two_modes, noisy(10), false, 15));
}

TEST(FrfVariance, CoversHitsThatDoNotRepeat) {
  // A gain that differs by 3 % from hit to hit dwarfs the noise: the error is
  // one number for all lines, so coverage is counted over records. Five hits
  // leave Student's t with 4 degrees of freedom: 86 % in 1.73 sd.
  GeneratedOptions o = noisy(5);
  o.spread = 0.03;
  o.response_noise = 0.002;
  const Coverage c = coverage(two_modes, o, false, 60);
  EXPECT_GT(c.share, 0.78);
  EXPECT_LT(c.share, 0.99);
}

TEST(FrfVariance, FallsWithTheNumberOfHits) {
  // Same noise: variance goes as one over the summed pulse energy.
  const auto mean_variance = [](int hits) {
    GeneratedTest test = generate_test(two_modes, noisy(hits));
    test.bundle.band_hz = {30.0, 50.0};
    const FrfSet set =
        estimate_frfs(test.bundle, test.recordings, test.hits, {});
    return set.frfs[0].variance.mean();
  };
  // Strengths 20, 26, 32 N repeated: sum of squares 2100 for three, 6776 for
  // ten. The variance itself is known to about a fifth.
  EXPECT_NEAR(mean_variance(3) / mean_variance(10), 6776.0 / 2100.0, 1.0);
}

TEST(FrfVariance, IsFiniteForDataWithoutNoise) {
  for (const int hits : {1, 3}) {
    GeneratedOptions o;
    o.hits = hits;
    const GeneratedTest test = generate_test(two_modes, o);
    const FrfSet set =
        estimate_frfs(test.bundle, test.recordings, test.hits, {});
    EXPECT_TRUE(set.frfs[0].variance.allFinite());
    EXPECT_GT(set.frfs[0].variance.minCoeff(), 0.0);
  }
}

}  // namespace
}  // namespace tapfit::signal
