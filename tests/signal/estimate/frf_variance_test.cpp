#include "signal/estimate/frf_variance.hpp"

#include "tests/signal/support/band_coverage.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <vector>

namespace tapfit::signal {
namespace {

const std::vector<TestMode> two_modes{{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}};

// Promised: 93 to 97 % of the truths in 95 % bands. Forty records of 140 to
// 750 lines, of which about one in three is independent, leave 0.5 % of chance.
void expect_covered(const Coverage& c) {
  fmt::print("covered: {:.1f} %, real and imaginary parts {:.1f} %\n",
             100.0 * c.share,
             100.0 * c.parts);
  EXPECT_GT(c.share, 0.93);
  EXPECT_LT(c.share, 0.97);
  EXPECT_GT(c.parts, 0.93);
  EXPECT_LT(c.parts, 0.97);
}

// Published quantiles of Student's t at 0.975; those of F(2, n) at 0.95.
TEST(ConfidenceBand, HasTheQuantilesOfTAndF) {
  Frf frf;
  frf.variance = Eigen::VectorXd::Constant(1, 2.0);
  const std::vector<std::array<double, 3>> published = {
      {24.0, 2.0639, 3.4028}, {40.0, 2.0211, 3.2317}, {120.0, 1.9799, 3.0718}};
  for (const auto& [n, t, F] : published) {
    frf.variance_freedom = n;
    EXPECT_NEAR(confidence_reach(frf)(0), t, 1e-3);
    EXPECT_NEAR(confidence_radius(frf)(0), std::sqrt(2.0 * F), 1e-3);
  }
  frf.variance_freedom = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(confidence_reach(frf)(0), 1.95996, 1e-4);
  EXPECT_NEAR(confidence_radius(frf)(0), std::sqrt(2.0 * std::log(20.0)), 1e-9);
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

// Blows that are a little askew bring in the response in another direction: a
// hundred times this one's at its own resonance, next to nothing at this one's.
// What scatters there is not lent to this one's.
TEST(FrfVariance, ScatterOfAnotherDirectionStaysWhereItIs) {
  constexpr Eigen::Index n = 100;
  constexpr double pi = 3.141592653589793;
  const auto mode = [](std::complex<double> s, double hz, double residue) {
    const double omega = 2.0 * pi * hz;
    return residue * s * s / (s * s + 0.01 * omega * s + omega * omega);
  };
  const std::vector<double> askew = {0.03, -0.02, -0.01};
  Eigen::VectorXcd s(n);
  CrossPowers powers;
  powers.hits = 3;
  powers.Gff = Eigen::VectorXd::Constant(n, 3.0);
  powers.Gyy = Eigen::VectorXd::Zero(n);
  powers.Gyf = Eigen::VectorXcd::Zero(n);
  LineNoise noise;
  noise.response = noise.force = Eigen::VectorXd::Constant(n, 1e-12);
  noise.bandwidth.resize(n);
  Eigen::VectorXd true_sd(n);
  for (Eigen::Index l = 0; l < n; ++l) {
    const double hz = 80.0 * std::pow(16.0, static_cast<double>(l) / n);
    s(l) = 2.0 * pi * hz * std::complex<double>(0.03, 1.0);
    noise.bandwidth(l) = pi * s(l).real();
    const std::complex<double> own = mode(s(l), 1000.0, 0.3);
    const std::complex<double> other = mode(s(l), 360.0, 1.0);
    for (const double a : askew) {
      const std::complex<double> Y = own + a * other;
      powers.Gyy(l) += std::norm(Y);
      powers.Gyf(l) += Y;
    }
    // Of the three angles, and of their mean.
    true_sd(l) = std::abs(other) * std::sqrt(14e-4 / 2.0 / 3.0);
  }
  const Eigen::VectorXcd H = powers.Gyf.cwiseQuotient(powers.Gff);
  const Eigen::VectorXd sd = frf_variance(s, powers, H, noise).cwiseSqrt();
  const Eigen::VectorXd ratio = sd.cwiseQuotient(true_sd);
  // Without minding the shape it is two hundred times at the resonance.
  EXPECT_GT(ratio.minCoeff(), 0.3);
  EXPECT_LT(ratio.maxCoeff(), 8.0);
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

// A record that begins with its only blow: the noise is known from its calm
// end, as well as from the quiet before the blow of another record.
TEST(FrfVariance, IsKnownWithoutQuietAndSaysSo) {
  const auto frfs = [](Eigen::Index lead) {
    GeneratedOptions o = noisy(1);
    o.force_noise = 0.0;  // known from the quiet alone
    o.lead = lead;
    GeneratedTest test = generate_test({{20.0, 0.05, 1.0}}, o);
    test.bundle.band_hz = {10.0, 70.0};
    return estimate_frfs(test.bundle, test.recordings, test.hits, {});
  };
  const FrfSet quiet = frfs(600);
  const FrfSet none = frfs(2);
  // The quiet's spectrum has some 44 degrees of freedom, a fifth at 1 sd.
  EXPECT_NEAR(
      none.frfs[0].variance.mean() / quiet.frfs[0].variance.mean(), 1.0, 0.5);
  const auto said = [](const FrfSet& set) {
    return std::ranges::any_of(set.statements, [](const std::string& text) {
      return text.find("no quiet before it") != std::string::npos;
    });
  };
  EXPECT_FALSE(said(quiet));
  EXPECT_TRUE(said(none));
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
