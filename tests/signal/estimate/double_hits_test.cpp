// FRFs of double hits, against the exact ones. A structure is linear: what
// follows two blows is the sum of what follows each,
//   f_2(t) = f(t) + p f(t - d),   y_2(t) = y(t) + p y(t - d).
#include "acquisition/hits/find_hits.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "tests/signal/support/generated_test.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using Eigen::Index;

constexpr double fs = 12800.0;  // pulses of 1 ms

// Five hits that decay by six time constants or more between them.
GeneratedTest single_hits() {
  GeneratedOptions o;
  o.fs = fs;
  o.block = 12800;
  o.pre_trigger = 200;
  o.lead = 3200;
  o.gap = 16000;
  o.hits = 5;
  GeneratedTest test = generate_test(
      {{60.0, 0.02, 1.0}, {150.0, 0.01, 0.8}, {330.0, 0.01, 1.5}}, o);
  test.bundle.band_hz = {20.0, 400.0};
  for (acquisition::Channel& channel : test.bundle.channels) {
    channel.full_scale_volts = 1e4;  // volts and SI units are the same
  }
  return test;
}

// Some of the hits with a second blow, then noise.
GeneratedTest doubled(const GeneratedTest& single,
                      double share,
                      Index delay,
                      int first) {
  GeneratedTest test = single;
  Eigen::MatrixXd& x = test.recordings[0].samples;
  for (int k = first; k < 5; ++k) {
    const Index from = 3200 + k * 16000 - 100;
    const Index count = std::min<Index>(16000, x.rows() - from);
    x.middleRows(from + delay, count - delay) +=
        share * single.recordings[0].samples.middleRows(from, count - delay);
  }
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  for (Index i = 0; i < x.rows(); ++i) {
    x(i, 0) += 2e-3 * normal(engine);
    x(i, 1) += 2e-3 * normal(engine);
  }
  return test;
}

struct Quality {
  double error = 0.0;    // relative, root of the mean over lines
  double covered = 0.0;  // share of lines within two stated deviations
  std::size_t hits = 0;
};

Quality quality_of(GeneratedTest test) {
  acquisition::HitOptions options;
  options.block_s = 1.0;
  options.trigger.hold_off_s = 1.0;
  test.hits = acquisition::find_hits(test.bundle, test.recordings, options);
  Quality quality;
  for (const acquisition::Hit& hit : test.hits.runs[0]) {
    quality.hits += hit.accepted ? 1 : 0;
  }
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  const Frf& frf = set.frfs.at(0);
  double wrong = 0.0;
  double all = 0.0;
  for (Index i = 0; i < set.s.size(); ++i) {
    const std::complex<double> exact = exact_frf(
        {{60.0, 0.02, 1.0}, {150.0, 0.01, 0.8}, {330.0, 0.01, 1.5}}, set.s(i));
    const double off = std::norm(frf.H(i) - exact);
    wrong += off;
    all += std::norm(exact);
    // The variance is that of both parts together.
    if (off <= 4.0 * frf.variance(i)) quality.covered += 1.0;
  }
  quality.error = std::sqrt(wrong / all);
  quality.covered /= static_cast<double>(set.s.size());
  return quality;
}

TEST(DoubleHits, FrfsAreAsExactAsThoseOfSingleOnes) {
  const GeneratedTest single = single_hits();
  const Quality clean = quality_of(doubled(single, 0.0, 20, 5));
  ASSERT_EQ(clean.hits, 5U);
  for (const double share : {0.02, 0.05, 0.1, 0.3, 0.6, 0.85, 1.0}) {
    for (const double after_s : {1.5e-3, 5e-3, 0.02, 0.1, 0.3, 0.6, 0.9}) {
      const auto delay = static_cast<Index>(std::lround(after_s * fs));
      const Quality some = quality_of(doubled(single, share, delay, 3));
      const std::string which = fmt::format(
          "{:3.0f} % after {:5.1f} ms: {} hits, error {:.5f} (single {:.5f}), "
          "within two deviations {:.2f} (single {:.2f})",
          100.0 * share,
          1e3 * after_s,
          some.hits,
          some.error,
          clean.error,
          some.covered,
          clean.covered);
      fmt::print("{}\n", which);
      EXPECT_GE(some.hits, 3U) << which;
      // What is kept costs at most what leaves the block: 1 % of two in five
      // hits, damped by the exponential window.
      EXPECT_LT(some.error, 1.5 * clean.error + 5e-4) << which;
      EXPECT_GT(some.covered, clean.covered - 0.1) << which;
    }
  }
}

// Nothing but double hits: none is as good as a single one, but together they
// give FRFs within their stated deviation.
TEST(DoubleHits, AloneGiveFrfsWithinTheirDeviation) {
  const GeneratedTest single = single_hits();
  for (const double share : {0.05, 0.08, 0.3, 0.6, 1.0}) {
    for (const double after_s : {1.5e-3, 0.02, 0.1}) {
      const auto delay = static_cast<Index>(std::lround(after_s * fs));
      const Quality only = quality_of(doubled(single, share, delay, 0));
      const std::string which = fmt::format(
          "{:3.0f} % after {:5.1f} ms: {} hits, error {:.5f}, "
          "within two deviations {:.2f}",
          100.0 * share,
          1e3 * after_s,
          only.hits,
          only.error,
          only.covered);
      fmt::print("{}\n", which);
      EXPECT_GE(only.hits, share < 0.8 ? 5U : 1U) << which;
      EXPECT_GT(only.covered, 0.85) << which;
    }
  }
}

}  // namespace
}  // namespace tapfit::signal
