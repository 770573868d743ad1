// Modes with known time constants in the block: what lasts is found with its
// frequency and rate, and what is proposed holds.
#include "signal/decay/block_advice.hpp"

#include "signal/estimate/estimate_frfs.hpp"
#include "tests/signal/support/generated_test.hpp"
#include "tests/support/matchers.hpp"

#include <cmath>
#include <complex>
#include <random>

namespace tapfit::signal {
namespace {

using std::numbers::pi;

double block_seconds(const GeneratedOptions& o) {
  return static_cast<double>(o.block - o.pre_trigger) / o.fs;
}

// A mode that falls by exp(-time_constants) within the block.
TestMode mode_with(double hz,
                   double time_constants,
                   const GeneratedOptions& o) {
  return {hz, time_constants / (2.0 * pi * hz * block_seconds(o)), 1.0};
}

GeneratedOptions noisy() {
  GeneratedOptions o;
  o.hits = 3;
  o.gap = 6000;
  o.response_noise = 0.002;
  o.force_noise = 0.002;
  return o;
}

struct Seen {
  DecayCheck lasting;
  std::optional<BlockAdvice> advice;
};

Seen look(const GeneratedTest& test) {
  const std::array<double, 2> band = *test.bundle.band_hz;
  const BlockOptions options{true, band[0], {}};
  Seen seen;
  seen.lasting = check_decay(cut_hits(test.bundle.runs[0],
                                      test.recordings[0],
                                      test.hits,
                                      test.hits.runs[0],
                                      options),
                             band);
  seen.advice = advise_block(
      seen.lasting, test.hits, {test.recordings[0].samples.rows()}, band);
  return seen;
}

// The rate is known to some percent: a block shorter by less is as good.
TEST(BlockAdvice, AsksForNoBlockThatIsHardlyLonger) {
  acquisition::HitSet hits;
  hits.sample_rate_hz = 1000.0;
  hits.block = 6000;
  DecayCheck lasting;
  lasting.low_hz = lasting.high_hz = lasting.hz = 20.0;
  lasting.rate = 6.0 / 6.2;
  EXPECT_FALSE(advise_block(lasting, hits, {}, {5.0, 95.0}));
  lasting.rate = 6.0 / 6.5;
  EXPECT_TRUE(advise_block(lasting, hits, {}, {5.0, 95.0}));
}

TEST(BlockAdvice, FindsWhatLastsAndHowLong) {
  for (const double time_constants : {0.5, 1.5, 3.0, 4.5}) {
    const GeneratedOptions o = noisy();
    GeneratedTest test = generate_test(
        {mode_with(20.0, time_constants, o), mode_with(61.0, 15.0, o)}, o);
    test.bundle.band_hz = {5.0, 95.0};
    const Seen seen = look(test);
    ASSERT_TRUE(seen.advice) << time_constants;
    // Noise of 0.002 under a response of some 0.05 that rings on from hit to
    // hit: a tenth of a time constant, more where more has gone.
    EXPECT_NEAR(seen.lasting.time_constants,
                time_constants,
                0.05 + 0.1 * time_constants);
    // Lines of half a block lie 0.25 Hz apart.
    EXPECT_NEAR(seen.lasting.hz, 20.0, 0.26) << time_constants;
    EXPECT_LT(seen.lasting.high_hz, 25.0);
    const double needed = 6.0 / (time_constants / block_seconds(o));
    EXPECT_NEAR(seen.advice->block_s - 0.125, needed, 0.2 * needed);
    ASSERT_TRUE(seen.advice->band_hz);
    EXPECT_GT((*seen.advice->band_hz)[0], 25.0);
    EXPECT_EQ((*seen.advice->band_hz)[1], 95.0);
  }
}

TEST(BlockAdvice, IsSilentWhereAllHasDecayed) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    GeneratedOptions o = noisy();
    o.seed = seed;
    GeneratedTest test =
        generate_test({mode_with(20.0, 8.0, o), mode_with(61.0, 15.0, o)}, o);
    test.bundle.band_hz = {5.0, 95.0};
    EXPECT_FALSE(look(test).advice) << seed;
  }
}

TEST(BlockAdvice, CountsTheHitsThatHaveRoom) {
  GeneratedOptions o = noisy();
  o.gap = 12000;  // 23 s; the last hit has but the block
  GeneratedTest test = generate_test({mode_with(20.0, 3.0, o)}, o);
  test.bundle.band_hz = {5.0, 95.0};
  const Seen seen = look(test);
  ASSERT_TRUE(seen.advice);
  EXPECT_EQ(seen.advice->accepted, 3);
  EXPECT_EQ(seen.advice->with_room, 2);
  EXPECT_TRUE(seen.advice->every_run);
  EXPECT_THAT(statement(*seen.advice, 0.0), HasSubstr("2 of 3 hits"));
  o.gap = 4100;
  test = generate_test({mode_with(20.0, 3.0, o)}, o);
  test.bundle.band_hz = {5.0, 95.0};
  const Seen narrow = look(test);
  ASSERT_TRUE(narrow.advice);
  EXPECT_FALSE(narrow.advice->every_run);
  EXPECT_THAT(statement(*narrow.advice, 0.0), HasSubstr("wait longer"));
}

TEST(BlockAdvice, HumIsNotTakenForAMode) {
  GeneratedOptions o = noisy();
  o.hum = 0.05;
  GeneratedTest test = generate_test({mode_with(20.0, 8.0, o)}, o);
  test.bundle.band_hz = {5.0, 95.0};
  Seen seen = look(test);
  EXPECT_FALSE(seen.advice);
  EXPECT_NEAR(seen.lasting.hum_hz, 50.0, 1.0);
  EXPECT_THAT(hum_statement(seen.lasting), HasSubstr("hum"));
  // A mode that lasts is found beside it.
  test = generate_test({mode_with(20.0, 3.0, o)}, o);
  test.bundle.band_hz = {5.0, 95.0};
  seen = look(test);
  ASSERT_TRUE(seen.advice);
  EXPECT_NEAR(seen.lasting.time_constants, 3.0, 0.35);
  EXPECT_NEAR(seen.lasting.hz, 20.0, 0.26);
  EXPECT_LT(seen.lasting.high_hz, 25.0);
  EXPECT_NEAR(seen.lasting.hum_hz, 50.0, 1.0);
}

// What wind makes of a mode: its answer to white noise, in equilibrium, its rms
// a share of the largest response.
void excite(const TestMode& mode,
            double share,
            unsigned seed,
            GeneratedTest& test) {
  using complex = std::complex<double>;
  const double fs = test.recordings[0].sample_rate_hz;
  const double w = 2.0 * pi * mode.hz;
  const complex step = std::exp(complex(-mode.zeta * w, w) / fs);
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  Eigen::Ref<Eigen::VectorXd> channel = test.recordings[0].samples.col(1);
  Eigen::VectorXd ambient(channel.size());
  complex z = normal(engine) / std::sqrt(1.0 - std::norm(step));
  for (double& value : ambient) {
    z = step * z + complex(normal(engine), normal(engine));
    value = z.imag();
  }
  const double rms =
      ambient.norm() / std::sqrt(static_cast<double>(ambient.size()));
  ambient *= share * channel.cwiseAbs().maxCoeff() / rms;
  channel += ambient;
}

// Modes with 4 to 13 time constants in the block, excited anew by 3 and 10 % of
// what the blow gives: the halves alone see 0 to 3. The fall is read within the
// first half of the block or less, and the ambient response adds to it or takes
// off as it comes: half more or less in 9 of 10 of them, and never thousands of
// seconds.
TEST(BlockAdvice, KnowsTheDecayOfWhatIsExcitedAnew) {
  int looked = 0;
  int right = 0;
  int excited = 0;
  for (const double time_constants : {4.0, 8.0, 13.0}) {
    for (const double share : {0.03, 0.1}) {
      for (unsigned seed = 1; seed <= 20; ++seed) {
        GeneratedOptions o = noisy();
        o.seed = seed;
        const TestMode mode = mode_with(20.0, time_constants, o);
        GeneratedTest test = generate_test({mode}, o);
        test.bundle.band_hz = {5.0, 95.0};
        excite(mode, share, seed, test);
        const Seen seen = look(test);
        const double block_s = seen.advice ? seen.advice->block_s - 0.125 : 0.0;
        const double needed = 6.0 * block_seconds(o) / time_constants;
        EXPECT_EQ(seen.lasting.hum_hz, 0.0) << time_constants << " " << seed;
        EXPECT_LT(block_s, 5.0 * needed) << time_constants << " " << seed;
        ++looked;
        right +=
            block_s < 1.5 * needed && (seen.advice ? block_s > needed / 1.5
                                                   : time_constants > 6.0 / 1.5)
                ? 1
                : 0;
        excited += seen.lasting.excited.hz > 0.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(right, 9 * looked / 10);
  // Of 4 time constants and 3 % a decay is left to the block's end.
  EXPECT_GE(excited, 3 * looked / 4);
}

// Nothing in these lasts: a mode that has decayed, excited by 2 to 10 % of what
// the blow gives. Two deviations are passed by chance in 2 or 3 of 100 where
// the truth lies at the limit, and it lies beyond.
TEST(BlockAdvice, AsksForNoLongerBlockWhereADecayEndsInAFloor) {
  int asked = 0;
  int looked = 0;
  for (const double time_constants : {7.5, 12.0}) {
    for (const double share : {0.02, 0.05, 0.1}) {
      for (unsigned seed = 1; seed <= 40; ++seed) {
        GeneratedOptions o = noisy();
        o.seed = seed;
        const TestMode mode = mode_with(20.0, time_constants, o);
        GeneratedTest test = generate_test({mode}, o);
        test.bundle.band_hz = {5.0, 95.0};
        excite(mode, share, seed, test);
        asked += look(test).advice ? 1 : 0;
        ++looked;
      }
    }
  }
  EXPECT_LE(asked, looked / 50);
}

// A mode that does last, excited by 1 %: its skirt is no hum, which would hide
// the mode, too.
TEST(BlockAdvice, TheSkirtOfWhatIsExcitedIsNoHum) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    GeneratedOptions o = noisy();
    o.seed = seed;
    const TestMode mode = mode_with(20.0, 3.0, o);
    GeneratedTest test = generate_test({mode}, o);
    test.bundle.band_hz = {5.0, 95.0};
    excite(mode, 0.01, seed, test);
    const Seen seen = look(test);
    EXPECT_EQ(seen.lasting.hum_hz, 0.0) << seed;
    EXPECT_TRUE(seen.advice) << seed;
  }
}

// Decays alone are not taken for it: long ones, two that beat, with noise and
// without.
TEST(BlockAdvice, DecaysThatBeatAreNotExcitedAnew) {
  for (const double noise : {0.0, 0.002, 0.02}) {
    for (const double time_constants : {0.3, 1.0, 3.0, 4.5}) {
      for (const double apart : {0.0, 0.3, 0.8, 2.5}) {
        GeneratedOptions o = noisy();
        o.force_noise = noise;
        o.response_noise = noise;
        // Of a beat that lasts longer than a half the halves tell nothing.
        if (time_constants < 3.0 && apart == 0.3) continue;
        const TestMode mode = mode_with(20.0, time_constants, o);
        TestMode close = mode_with(20.0 + apart, time_constants, o);
        close.gain = 0.6;
        GeneratedTest test = generate_test({mode, close}, o);
        test.bundle.band_hz = {5.0, 95.0};
        const Seen seen = look(test);
        ASSERT_TRUE(seen.advice) << time_constants << " " << apart;
        EXPECT_TRUE(excited_statement(seen.lasting).empty())
            << time_constants << " " << apart << " " << noise;
        const double needed = 6.0 * block_seconds(o) / time_constants;
        EXPECT_LT(seen.advice->block_s, 1.5 * needed + 0.125)
            << time_constants << " " << apart << " " << noise;
        EXPECT_GT(seen.advice->block_s, needed / 1.5)
            << time_constants << " " << apart << " " << noise;
      }
    }
  }
}

// Hum that was there before a mode beside it was struck is hum still.
TEST(BlockAdvice, HumBesideAModeThatDecaysIsNotExcitedAnew) {
  for (const double hz : {40.0, 48.0}) {
    GeneratedOptions o = noisy();
    o.hum = 0.05;
    GeneratedTest test = generate_test({mode_with(hz, 8.0, o)}, o);
    test.bundle.band_hz = {5.0, 95.0};
    const Seen seen = look(test);
    EXPECT_TRUE(excited_statement(seen.lasting).empty()) << hz;
    EXPECT_FALSE(seen.advice) << hz;
    EXPECT_NEAR(seen.lasting.hum_hz, 50.0, 0.3) << hz;
  }
}

// The proposal comes before what the window costs, and taking it works: with
// the block proposed there is nothing more to say.
TEST(BlockAdvice, ComesFirstAndHolds) {
  GeneratedOptions o = noisy();
  o.gap = 12000;
  const std::vector<TestMode> modes{mode_with(20.0, 3.0, o)};
  GeneratedTest test = generate_test(modes, o);
  test.bundle.band_hz = {5.0, 95.0};
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  ASSERT_FALSE(set.statements.empty());
  const std::string& said = set.statements.front();
  EXPECT_LT(said.find("a block of"), said.find("window widens"));
  EXPECT_EQ(
      said,
      block_statements(test.bundle, test.recordings, test.hits, {}).front());
  const Seen seen = look(test);
  test.hits.block =
      static_cast<Eigen::Index>(1.05 * o.fs * seen.advice->block_s);
  test.hits.runs[0].back().accepted = false;  // ends with the file
  EXPECT_TRUE(
      block_statements(test.bundle, test.recordings, test.hits, {}).empty());
}

}  // namespace
}  // namespace tapfit::signal
