#include "signal/estimate/estimate_frfs.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/signal/support/generated_test.hpp"
#include "tests/support/matchers.hpp"

#include <chrono>
#include <cmath>

namespace tapfit::signal {
namespace {

using std::numbers::pi;

const std::vector<TestMode> two_modes{{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}};

// Largest |H - exact| of a line, relative to |exact|, inside a band.
double worst_error(const FrfSet& set,
                   const std::vector<TestMode>& modes,
                   double low_hz,
                   double high_hz) {
  const Eigen::VectorXd f = set.frequency_hz();
  double worst = 0.0;
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    if (f(i) < low_hz || f(i) > high_hz) continue;
    const std::complex<double> exact = exact_frf(modes, set.s(i));
    worst =
        std::max(worst, std::abs(set.frfs[0].H(i) - exact) / std::abs(exact));
  }
  return worst;
}

Eigen::VectorXcd damped_line(double sigma,
                             double low_hz,
                             double high_hz,
                             Eigen::Index n) {
  Eigen::VectorXcd s(n);
  s.real().setConstant(sigma);
  s.imag().setLinSpaced(n, 2.0 * pi * low_hz, 2.0 * pi * high_hz);
  return s;
}

FrfOptions ending_at(double end_value) {
  FrfOptions options;
  options.window.end_value = end_value;
  return options;
}

TEST(EstimateFrfs, IsExactWithoutWindowWhenTheResponseHasDecayed) {
  // 20 Hz at 1 %: time constant 0.8 s; the block of 8 s holds ten of them.
  const GeneratedTest test = generate_test(two_modes, {});
  const FrfSet set =
      estimate_frfs(test.bundle, test.recordings, test.hits, ending_at(1.0));
  ASSERT_EQ(set.frfs.size(), 1u);
  // At the block's end exp(-10) = 5e-5 of the response is left, which counts
  // most where |H| is small: 0.009 at 2 Hz against a peak of 50.
  EXPECT_LT(worst_error(set, two_modes, 4.0, 95.0), 1e-3);
  EXPECT_LT(worst_error(set, two_modes, 2.0, 95.0), 5e-3);
}

TEST(EstimateFrfs, IsExactOnItsLineWithAWindow) {
  // Decay to exp(-2.5) only, and a window that ends at 1 %: the block's end
  // cuts off 8e-4 of the peak.
  GeneratedOptions o;
  o.block = 1024 + 64;
  const GeneratedTest test = generate_test(two_modes, o);
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  const double sigma = -std::log(0.01) / 2.0;
  EXPECT_NEAR(set.s(0).real(), sigma, 1e-12);
  EXPECT_LT(worst_error(set, two_modes, 10.0, 90.0), 5e-3);
  EXPECT_LT(worst_error(set, two_modes, 15.0, 25.0), 2e-3);
}

TEST(EstimateFrfs, LightlyDampedModeNeedsTheWindow) {
  // 0.05 % damping: the response has lost 12 % when the block ends.
  const std::vector<TestMode> mode{{20.0, 0.0005, 1.0}};
  GeneratedOptions o;
  o.block = 1024 + 64;
  const GeneratedTest test = generate_test(mode, o);
  const FrfSet windowed =
      estimate_frfs(test.bundle, test.recordings, test.hits, {});
  const FrfSet bare =
      estimate_frfs(test.bundle, test.recordings, test.hits, ending_at(1.0));
  // 1 % is what the window leaves; without it the peak's lines mean nothing.
  EXPECT_LT(worst_error(windowed, mode, 18.0, 22.0), 1.5e-2);
  EXPECT_GT(worst_error(bare, mode, 18.0, 22.0), 0.3);
}

TEST(EstimateFrfs, KeepsSignsAndNames) {
  const GeneratedTest test = generate_test(two_modes, {});
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  EXPECT_EQ(name(set.frfs[0]), "7Z- / 3Z+");
  EXPECT_EQ(set.frfs[0].channel, 1u);
  EXPECT_EQ(set.frfs[0].hits, 1);
  EXPECT_TRUE((set.frfs[0].coherence.array() == 1.0).all());
}

TEST(EstimateFrfs, TakesLinesInsideTheBand) {
  GeneratedTest test = generate_test(two_modes, {});
  test.bundle.band_hz = {10.0, 80.0};
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  EXPECT_EQ(set.frequency_hz()(0), 10.0);
  EXPECT_EQ(set.frequency_hz()(set.lines() - 1), 80.0);
  test.bundle.band_hz = {300.0, 400.0};
  EXPECT_THROW((void)estimate_frfs(test.bundle, test.recordings, test.hits, {}),
               InputError);
}

TEST(EstimateFrfs, LeavesOutRejectedHits) {
  GeneratedOptions o;
  o.hits = 3;
  GeneratedTest test = generate_test(two_modes, o);
  // Poison the second hit, then reject it.
  test.recordings[0].samples.block(o.lead + o.gap + 40, 1, 300, 1).array() +=
      5.0;
  test.hits.runs[0][1].accepted = false;
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  EXPECT_EQ(set.frfs[0].hits, 2);
  EXPECT_LT(worst_error(set, two_modes, 15.0, 70.0), 1e-2);
}

TEST(EstimateFrfs, SkipsARunWithoutAcceptedHitsAndSaysSo) {
  GeneratedTest test = generate_test(two_modes, {});
  test.bundle.runs.push_back(test.bundle.runs[0]);
  test.recordings.push_back(test.recordings[0]);
  test.hits.runs.push_back(test.hits.runs[0]);
  test.hits.runs[0][0].accepted = false;
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  ASSERT_EQ(set.frfs.size(), 1u);
  EXPECT_EQ(set.frfs[0].run, 1u);
  EXPECT_EQ(set.statements.size(), 1u);
  test.hits.runs[1][0].accepted = false;
  EXPECT_THROW((void)estimate_frfs(test.bundle, test.recordings, test.hits, {}),
               InputError);
}

// A file for each hit gives what one file of them all does; the sensors may be
// listed in another order.
TEST(EstimateFrfs, AveragesRunsOfOnePlacementTogether) {
  GeneratedOptions o;
  o.hits = 5;
  o.response_noise = 0.02;
  o.force_noise = 0.01;
  const GeneratedTest whole = generate_test(two_modes, o);
  GeneratedTest parts = whole;
  parts.hits.runs.assign(5, whole.hits.runs[0]);
  for (std::size_t r = 0; r < 5; ++r) {
    for (std::size_t k = 0; k < 5; ++k) {
      parts.hits.runs[r][k].accepted = k == r;
    }
    if (r == 0) continue;
    parts.bundle.runs.push_back(whole.bundle.runs[0]);
    parts.recordings.push_back(whole.recordings[0]);
  }
  const FrfSet one =
      estimate_frfs(whole.bundle, whole.recordings, whole.hits, {});
  const FrfSet set =
      estimate_frfs(parts.bundle, parts.recordings, parts.hits, {});
  ASSERT_EQ(set.frfs.size(), 1U);
  const Frf& mine = set.frfs[0];
  const Frf& theirs = one.frfs[0];
  EXPECT_EQ(mine.hits, 5);
  EXPECT_EQ(mine.run, 0U);
  // The same sums in another order.
  EXPECT_LT((mine.H - theirs.H).norm(), 1e-12 * theirs.H.norm());
  EXPECT_LT((mine.coherence - theirs.coherence).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(mine.change_with_level.size(), theirs.change_with_level.size());
  // The noise's spectrum is smoothed per run instead of over all hits.
  EXPECT_LT(
      (mine.variance.array() / theirs.variance.array() - 1.0).abs().maxCoeff(),
      0.2);
  EXPECT_TRUE(set.statements.empty());

  // Hit elsewhere they are FRFs of their own, as before.
  parts.bundle.runs[4].hammer.dof.node += 1;
  const FrfSet two =
      estimate_frfs(parts.bundle, parts.recordings, parts.hits, {});
  ASSERT_EQ(two.frfs.size(), 2U);
  EXPECT_EQ(two.frfs[0].hits, 4);
  EXPECT_EQ(two.frfs[1].run, 4U);
}

// A sensitivity that was changed after the first two of five files.
TEST(EstimateFrfs, SaysWhereRunsOfOnePlacementDiffer) {
  GeneratedOptions o;
  o.hits = 3;
  o.spread = 0.01;
  GeneratedTest test = generate_test(two_modes, o);
  for (unsigned r = 1; r < 5; ++r) {
    o.seed = r + 1;
    GeneratedTest more = generate_test(two_modes, o);
    if (r > 1) more.recordings[0].samples.col(1) *= 1.25;
    test.bundle.runs.push_back(more.bundle.runs[0]);
    test.recordings.push_back(more.recordings[0]);
    test.hits.runs.push_back(more.hits.runs[0]);
  }
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  ASSERT_EQ(set.frfs.size(), 1U);
  ASSERT_FALSE(set.statements.empty());
  EXPECT_THAT(set.statements[0],
              HasSubstr("runs 1, 2, 3, 4 and 5 measured the same"));
}

TEST(EstimateFrfs, OffsetDriftAndHumDoNotReachTheLowLines) {
  // An offset twenty times the noise-free response's rms at the end, a drift
  // and hum beyond the band, with a pre-trigger of an eighth of a second only.
  GeneratedOptions o;
  o.hits = 3;
  o.offset = 0.5;
  o.drift = 0.002;
  o.hum = 0.02;
  o.hum_hz = 150.0;
  GeneratedTest test = generate_test(two_modes, o);
  test.bundle.band_hz = {4.0, 100.0};
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  // The same without any of it is below 2e-3; a mean over 64 samples leaves
  // 2e-3 m/s^2 of hum as a step, 5 % at 4 Hz, where |H| is 0.04.
  EXPECT_LT(worst_error(set, two_modes, 15.0, 70.0), 1e-2);
  EXPECT_LT(worst_error(set, two_modes, 4.0, 15.0), 2e-2);
}

TEST(EstimateFrfs, VelocityAndDisplacementBecomeAccelerance) {
  GeneratedTest test = generate_test(two_modes, {});
  const FrfSet a = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  test.bundle.channels[1].quantity = acquisition::Quantity::Velocity;
  const FrfSet v = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  const Eigen::VectorXcd expected = a.frfs[0].H.cwiseProduct(a.s);
  EXPECT_LT((v.frfs[0].H - expected).norm(), 1e-12 * expected.norm());
}

TEST(EstimateFrfsAt, EqualsTheTransferFunctionOnADampedLine) {
  // sigma = 5 1/s over 7.9 s: sigma T = 39, nothing is cut off. What is left
  // is aliasing of the pulse (1e-4) and the substeps' force (2e-5).
  const GeneratedTest test = generate_test(two_modes, {});
  const FrfSet set = estimate_frfs_at(test.bundle,
                                      test.recordings,
                                      test.hits,
                                      damped_line(5.0, 2.0, 95.0, 140),
                                      {});
  EXPECT_LT(worst_error(set, two_modes, 2.0, 95.0), 5e-4);
}

TEST(EstimateFrfsAt, LightDampingAndShortBlocksAreExactToo) {
  // sigma T = 10: exp(-10) = 5e-5 of an undamped response, at its peak.
  const std::vector<TestMode> mode{{20.0, 0.0005, 1.0}};
  GeneratedOptions o;
  o.block = 1024 + 64;
  const GeneratedTest test = generate_test(mode, o);
  const FrfSet set = estimate_frfs_at(test.bundle,
                                      test.recordings,
                                      test.hits,
                                      damped_line(5.0, 2.0, 95.0, 140),
                                      {});
  EXPECT_LT(worst_error(set, mode, 10.0, 60.0), 1e-3);
}

TEST(EstimateFrfsAt, AgreesWithTheFftLines) {
  GeneratedOptions o;
  o.hits = 3;
  o.response_noise = 0.01;
  GeneratedTest test = generate_test(two_modes, o);
  test.bundle.band_hz = {4.0, 95.0};
  const FrfSet fft = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  const FrfSet at =
      estimate_frfs_at(test.bundle, test.recordings, test.hits, fft.s, {});
  // The same lines, the same offset: rounding only.
  EXPECT_LT((fft.frfs[0].H - at.frfs[0].H).norm(), 1e-9 * fft.frfs[0].H.norm());
  EXPECT_LT((fft.frfs[0].variance - at.frfs[0].variance).norm(),
            1e-6 * fft.frfs[0].variance.norm());
}

TEST(EstimateFrfsAt, TakesLinesWithDifferentDecay) {
  const GeneratedTest test = generate_test(two_modes, {});
  Eigen::VectorXcd s(3);
  s << std::complex<double>(1.5, 125.0), std::complex<double>(10.0, 300.0),
      std::complex<double>(40.0, 380.0);
  const FrfSet set =
      estimate_frfs_at(test.bundle, test.recordings, test.hits, s, {});
  EXPECT_LT(worst_error(set, two_modes, 0.0, 1e3), 1e-3);
  s(0) = {-1.0, 10.0};
  EXPECT_THROW(
      (void)estimate_frfs_at(test.bundle, test.recordings, test.hits, s, {}),
      InputError);
}

TEST(EstimateFrfs, StopsWhenAsked) {
  const GeneratedTest test = generate_test(two_modes, {});
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)estimate_frfs(test.bundle,
                                   test.recordings,
                                   test.hits,
                                   {},
                                   {nullptr, source.get_token()}),
               Stopped);
}

}  // namespace
}  // namespace tapfit::signal
