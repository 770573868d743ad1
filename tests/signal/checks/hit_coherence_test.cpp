#include "signal/checks/hit_coherence.hpp"

#include "tests/signal/support/generated_test.hpp"

#include <gtest/gtest.h>

namespace tapfit::signal {
namespace {

const std::vector<TestMode> two_modes{{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}};

// The definition by hand: two lines, two hits, F = 1 for both.
TEST(HitCoherence, IsTheDefinition) {
  Spectra spectra;
  spectra.force = Eigen::MatrixXcd::Ones(2, 2);
  Eigen::MatrixXcd Y(2, 2);
  Y << 1.0, 1.0, 1.0, std::complex<double>(0.0, 1.0);
  spectra.responses = {Y};
  const HitCoherence c = hit_coherence(spectra);
  // Line 1: |2|^2 / (2 2) = 1; line 2: |1 + j|^2 / 4 = 1/2.
  EXPECT_DOUBLE_EQ(c.pairs.at(0)(0, 1), 0.75);
  EXPECT_DOUBLE_EQ(c.with_others(0, 1), 0.75);
}

GeneratedTest noisy(unsigned seed) {
  GeneratedOptions o;
  o.hits = 6;
  o.response_noise = 0.02;
  o.force_noise = 0.01;
  o.seed = seed;
  GeneratedTest test = generate_test(two_modes, o);
  test.bundle.band_hz = {5.0, 100.0};
  return test;
}

TEST(HitCoherence, LeavesGoodHitsAlone) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const GeneratedTest test = noisy(seed);
    const HitCoherence c =
        group_coherence(test.bundle, test.recordings, test.hits, {0});
    ASSERT_EQ(c.hits.size(), 6u);
    EXPECT_TRUE(hits_apart(c).empty()) << "seed " << seed;
  }
}

// A hit on another point: 30 % of another mode's answer in place of its own.
TEST(HitCoherence, FindsTheHitThatStandsApart) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    GeneratedTest test = noisy(seed);
    GeneratedOptions o;
    o.hits = 6;
    const GeneratedTest elsewhere =
        generate_test({{20.0, 0.01, 0.7}, {61.0, 0.008, 0.4}}, o);
    auto block = [&](auto& of) {
      return of.samples.block(o.lead + 2 * o.gap, 1, o.gap, 1);
    };
    block(test.recordings[0]) = block(elsewhere.recordings[0]);
    const HitCoherence c =
        group_coherence(test.bundle, test.recordings, test.hits, {0});
    EXPECT_EQ(hits_apart(c), (std::vector<HitAt>{{0, 2}})) << "seed " << seed;
    Eigen::Index worst = 0;
    c.with_others.row(0).minCoeff(&worst);
    EXPECT_EQ(worst, 2);
  }
}

// A file for each hit: what one says of the others is what it says in one file.
TEST(HitCoherence, GoesOverAllRunsOfAPlacement) {
  const GeneratedTest whole = noisy(3);
  const HitCoherence expected =
      group_coherence(whole.bundle, whole.recordings, whole.hits, {0});
  GeneratedTest parts = whole;
  parts.hits.runs.assign(6, whole.hits.runs[0]);
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t k = 0; k < 6; ++k) {
      parts.hits.runs[r][k].accepted = k == r;
    }
    if (r == 0) continue;
    parts.bundle.runs.push_back(whole.bundle.runs[0]);
    parts.recordings.push_back(whole.recordings[0]);
  }
  const HitCoherence c = group_coherence(
      parts.bundle, parts.recordings, parts.hits, {0, 1, 2, 3, 4, 5});
  ASSERT_EQ(c.hits.size(), 6U);
  EXPECT_EQ(c.hits[4], (HitAt{4, 4}));
  // The same numbers, summed alike; the FFT is the same one.
  EXPECT_LT((c.with_others - expected.with_others).cwiseAbs().maxCoeff(),
            1e-12);
  const RunCoherence fifth = part_of(c, parts.bundle, 4);
  EXPECT_EQ(fifth.hits, std::vector<std::size_t>{4});
  ASSERT_EQ(fifth.with_others.cols(), 1);
  EXPECT_EQ(fifth.with_others(0, 0), c.with_others(0, 4));
}

TEST(HitCoherence, OneHitHasNoOther) {
  GeneratedTest test = noisy(1);
  for (std::size_t k = 1; k < 6; ++k) test.hits.runs[0][k].accepted = false;
  const HitCoherence c =
      group_coherence(test.bundle, test.recordings, test.hits, {0});
  EXPECT_TRUE(c.pairs.empty());
  EXPECT_TRUE(hits_apart(c).empty());
}

}  // namespace
}  // namespace tapfit::signal
