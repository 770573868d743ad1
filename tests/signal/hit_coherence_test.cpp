#include "signal/hit_coherence.hpp"

#include "tests/signal/generated_test.hpp"

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
        run_coherence(test.bundle, test.recordings, test.hits, 0);
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
        run_coherence(test.bundle, test.recordings, test.hits, 0);
    EXPECT_EQ(hits_apart(c), std::vector<std::size_t>{2}) << "seed " << seed;
    Eigen::Index worst = 0;
    c.with_others.row(0).minCoeff(&worst);
    EXPECT_EQ(worst, 2);
  }
}

TEST(HitCoherence, OneHitHasNoOther) {
  GeneratedTest test = noisy(1);
  for (std::size_t k = 1; k < 6; ++k) test.hits.runs[0][k].accepted = false;
  const HitCoherence c =
      run_coherence(test.bundle, test.recordings, test.hits, 0);
  EXPECT_TRUE(c.pairs.empty());
  EXPECT_TRUE(hits_apart(c).empty());
}

}  // namespace
}  // namespace tapfit::signal
