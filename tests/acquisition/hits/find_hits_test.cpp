#include "acquisition/hits/find_hits.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/choose_block.hpp"
#include "acquisition/hits/hits.hpp"
#include "acquisition/samples/statistics.hpp"
#include "tests/acquisition/support/hit_scene.hpp"
#include "tests/support/matchers.hpp"

#include <algorithm>
#include <filesystem>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using testing::blames;
using testing::find;
using testing::reasons;
using testing::record;
using testing::Scene;

TEST(FindHits, FindsTimePeakAndWidth) {
  const Scene scene;
  const HitSet hits = find({record(scene)});
  ASSERT_EQ(hits.runs[0].size(), scene.blows.size());
  for (std::size_t i = 0; i < scene.blows.size(); ++i) {
    const Hit& hit = hits.runs[0][i];
    EXPECT_TRUE(hit.accepted) << reasons(hit);
    EXPECT_NEAR(hit.time_s, scene.blows[i].time_s, 1.0 / scene.rate);
    // Four samples in a half sine: a parabola is good to a few per cent.
    EXPECT_NEAR(hit.peak_n, scene.blows[i].peak_n, 0.05 * hit.peak_n);
    // 10 % points of a half sine: 0.936 of its base; the filter widens it.
    EXPECT_NEAR(hit.pulse_s, 0.936 * scene.width_s, 0.5 / scene.rate);
  }
  EXPECT_GE(hits.statements.size(), 2U);
}

TEST(FindHits, BlocksFillTheGapsAndHoldOneHitEach) {
  Scene scene;
  scene.decay = 0.1;  // rings on from hit to hit
  const HitSet hits = find({record(scene)});
  const auto& run = hits.runs[0];
  EXPECT_GT(hits.block, 0.95 * 4.0 * scene.rate);
  for (std::size_t i = 0; i < run.size(); ++i) {
    EXPECT_TRUE(run[i].accepted) << reasons(run[i]);
    EXPECT_EQ(run[i].trigger - run[i].begin, hits.pre_trigger);
    const Index end = run[i].begin + hits.block;
    EXPECT_LE(end, static_cast<Index>(scene.length_s * scene.rate));
    if (i + 1 < run.size()) {
      EXPECT_LT(end, run[i + 1].trigger - 4);
    }
  }
}

TEST(FindHits, BlocksEndWhenTheResponseHasDied) {
  Scene scene;
  scene.decay = 20.0;  // below 1e-3 after 0.35 s; 200 lines need 1.03 s
  const HitSet hits = find({record(scene)});
  const double block_s = static_cast<double>(hits.block) / scene.rate;
  EXPECT_GT(block_s, 1.0);
  EXPECT_LT(block_s, 1.2);
}

TEST(FindHits, HumDoesNotHideTheResponseFromTheBlock) {
  Scene scene;
  scene.decay = 2.0;  // six time constants are 3 s of the 4 between hits
  Recording recording = record(scene);
  Eigen::VectorXd hum = Eigen::VectorXd::LinSpaced(
      recording.samples.rows(), 0.0, 2.0 * std::numbers::pi * 150.0);
  hum *= scene.length_s;
  recording.samples.col(1).array() +=
      0.05 * recording.samples.col(1).maxCoeff() * hum.array().sin();
  const HitSet hits = find({recording});
  const double after_s =
      static_cast<double>(hits.block - hits.pre_trigger) / scene.rate;
  EXPECT_GT(after_s, 3.0);
  EXPECT_LT(after_s, 3.6);
  EXPECT_TRUE(std::ranges::any_of(hits.statements, [](const auto& said) {
    return said.find("time constants of 0.5") != std::string::npos;
  })) << ::testing::PrintToString(hits.statements);
}

TEST(FindHits, ADoubleHitShortensNoBlock) {
  Scene scene;
  scene.decay = 0.1;
  scene.blows.push_back({5.05, 9.0});
  const HitSet hits = find({record(scene)});
  ASSERT_EQ(hits.runs[0].size(), 4U);
  EXPECT_EQ(reasons(hits.runs[0][1]), "double ");
  EXPECT_TRUE(hits.runs[0][2].accepted) << reasons(hits.runs[0][2]);
  EXPECT_GT(hits.block, 0.95 * 4.0 * scene.rate);
}

TEST(FindHits, OneHitTooSoonIsGivenUpForTheOthers) {
  Scene scene;
  scene.decay = 0.1;
  scene.length_s = 31.0;
  scene.blows = {{1.0}, {5.0}, {6.6}, {11.0}, {15.0}, {19.0}, {23.0}, {27.0}};
  const HitSet hits = find({record(scene)});
  ASSERT_EQ(hits.runs[0].size(), 8U);
  EXPECT_TRUE(blames(hits.runs[0][1], HitFault::Double));
  EXPECT_TRUE(hits.runs[0][2].accepted) << reasons(hits.runs[0][2]);
  EXPECT_GT(hits.block, 0.9 * 4.0 * scene.rate);
}

TEST(FindHits, BlowsMayBeNegativeInTheFile) {
  Recording recording = record({});
  recording.samples.col(0) *= -1.0;
  const HitSet hits = find({recording});
  ASSERT_EQ(hits.runs[0].size(), 4U);
  EXPECT_NEAR(hits.runs[0][1].peak_n, 30.0, 1.5);
  EXPECT_THAT(hits.statements.back(), HasSubstr("negative"));
}

TEST(FindHits, DriftAndHumDoNotMatter) {
  Recording recording = record({});
  for (Index i = 0; i < recording.samples.rows(); ++i) {
    const double t = static_cast<double>(i) / recording.sample_rate_hz;
    recording.samples(i, 0) +=
        2.0 * t - 0.05 * t * t + 0.1 * std::sin(314.16 * t);
  }
  const HitSet hits = find({recording});
  ASSERT_EQ(hits.runs[0].size(), 4U);
  for (const Hit& hit : hits.runs[0]) {
    EXPECT_TRUE(hit.accepted) << reasons(hit);
  }
}

TEST(FindHits, AWeakHitIsJudgedOut) {
  Scene scene;
  scene.blows[2].peak_n = 2.0;
  const HitSet hits = find({record(scene)});
  ASSERT_EQ(hits.runs[0].size(), 4U);
  EXPECT_TRUE(blames(hits.runs[0][2], HitFault::Weak));
}

TEST(FindHits, AHitInNoiseIsWeakButKeptWhenThereIsNoOther) {
  Scene scene;
  scene.noise = 1.3;  // 20 N is 15 times that
  scene.blows = {{1.0, 20.0}};
  const HitSet hits = find({record(scene)});
  ASSERT_EQ(hits.runs[0].size(), 1U);
  EXPECT_EQ(reasons(hits.runs[0][0]), "weak ");
  EXPECT_TRUE(hits.runs[0][0].accepted);
  EXPECT_THAT(hits.statements.back(), HasSubstr("kept"));
}

TEST(FindHits, ASoftTipIsNoticed) {
  Scene scene;
  // Half sine of 10 ms: first zero of its spectrum at 150 Hz, so at 200 Hz
  // it is more than 23 dB down.
  scene.width_s = 0.010;
  const HitSet soft = find({record(scene)});
  for (const Hit& hit : soft.runs[0]) EXPECT_EQ(reasons(hit), "soft ");
  scene.width_s = 0.005;  // at 200 Hz 12 dB down
  const HitSet good = find({record(scene)});
  for (const Hit& hit : good.runs[0]) EXPECT_EQ(reasons(hit), "");
}

// Half sines of 10 ms have fallen by 10 dB at 102 Hz:
// |cos(pi f w) / (1 - (2 f w)^2)| = 0.316 at f w = 1.0194. There are 20 samples
// over the pulse: the sum is good to (1/20)^2.
TEST(FindHits, WithoutABandHitsNeedNotReachFartherThanTheUsualOne) {
  Scene scene;
  scene.width_s = 0.010;
  const TestBundle bundle = testing::hammer_bundle();
  const HitSet hits = find_hits(bundle, {record(scene)}, {});
  for (const Hit& hit : hits.runs[0]) EXPECT_EQ(reasons(hit), "");
  EXPECT_NEAR(hits.usable_bandwidth_hz, 101.94, 0.0025 * 101.94);
  EXPECT_TRUE(std::any_of(
      hits.statements.begin(), hits.statements.end(), [](const auto& said) {
        return said.find("no band is given") == 0;
      }));
  scene.width_s = 0.002;
  Recording mixed = record(scene);
  // The second blow is 10 ms long: 38 dB down where the others have 10.
  mixed.samples.col(0).segment(9000, 2000).setConstant(0.3);
  Eigen::VectorXd force = mixed.samples.col(0);
  testing::add_pulse(force, scene.rate, 5.0, 0.010, 30.0, false);
  mixed.samples.col(0) = force;
  const HitSet one = find_hits(bundle, {mixed}, {});
  ASSERT_EQ(one.runs[0].size(), 4U);
  EXPECT_EQ(reasons(one.runs[0][0]), "");
  EXPECT_EQ(reasons(one.runs[0][1]), "soft ");
}

TEST(FindHits, AHitTooNearTheEndIsTruncatedAndStaysOut) {
  Scene scene;
  scene.decay = 0.1;
  scene.length_s = 21.0 + 0.3;
  scene.blows = {{1.0}, {5.0}, {9.0}, {13.0}, {17.0}, {21.0}};
  HitSet hits = find({record(scene)});
  Hit& last = hits.runs[0].back();
  EXPECT_TRUE(blames(last, HitFault::Truncated));
  overrule(last);
  EXPECT_FALSE(last.accepted);
  EXPECT_GT(hits.block, 3.5 * scene.rate);
}

TEST(FindHits, AnOutlierIsNoticed) {
  const Scene scene;
  Recording recording = record(scene);
  // One blow that moved the structure twice as much per impulse.
  Eigen::VectorXd response = recording.samples.col(1);
  testing::add_response(
      response, scene.rate, 9.0, scene.frequency, scene.decay, 25.0);
  recording.samples.col(1) = response;
  const HitSet hits = find({recording});
  EXPECT_TRUE(blames(hits.runs[0][2], HitFault::Outlier));
  EXPECT_TRUE(hits.runs[0][1].accepted);
}

TEST(FindHits, OverloadIsJudgedAgainstDeclaredFullScale) {
  Recording recording = record({});
  recording.samples.col(1) =
      (recording.samples.col(1) * 20.0).cwiseMin(500.0);  // full scale
  const HitSet hits = find({recording});
  EXPECT_TRUE(blames(hits.runs[0][1], HitFault::Overload));
  EXPECT_TRUE(hits.runs[0][3].accepted) << reasons(hits.runs[0][3]);
}

TEST(FindHits, ARunWithNothingButBadHitsStaysEmpty) {
  Scene scene;
  scene.blows = {{2.0}};
  Recording bad = record(scene);
  bad.samples.col(1) =
      (bad.samples.col(1) * 40.0).cwiseMin(500.0);  // full scale
  const HitSet hits = find({record({}), bad});
  ASSERT_EQ(hits.runs[1].size(), 1U);
  EXPECT_FALSE(hits.runs[1][0].accepted);
  EXPECT_THAT(hits.statements.back(), HasSubstr("not used"));
}

TEST(FindHits, ARunWithoutHitsIsRefused) {
  Scene empty;
  empty.blows.clear();
  EXPECT_THROW((void)find({record({}), record(empty)}), InputError);
  Recording silence = record({});
  silence.samples.setZero();
  EXPECT_THROW((void)find({silence}), InputError);
  Recording tiny;
  tiny.sample_rate_hz = 100.0;
  tiny.samples = Eigen::MatrixXd::Zero(1, 2);
  EXPECT_THROW((void)find({tiny}), InputError);
  EXPECT_THROW((void)find({}), InputError);
}

TEST(FindHits, OverruleTurnsOverAndBack) {
  Hit hit;
  hit.accepted = false;
  hit.reasons = {HitFault::Double};
  overrule(hit);
  EXPECT_TRUE(hit.accepted);
  EXPECT_EQ(reasons(hit), "double by hand ");
  overrule(hit);
  EXPECT_FALSE(hit.accepted);
  EXPECT_EQ(reasons(hit), "double ");
}

TEST(SmoothLength, HasSmallFactorsOnly) {
  EXPECT_EQ(smooth_length(8307), 8232);  // 2^3 3 7^3
  EXPECT_EQ(smooth_length(4096), 4096);
  EXPECT_EQ(smooth_length(2), 2);
}

// Recordings made by others, with known spacing: three hits in each run, all
// of them found; no block is lost but to double hits.
TEST(FindHits, ReadsTheCases) {
  const std::filesystem::path cases = TAPFIT_SOURCE_DIR "/../shared/cases";
  if (!std::filesystem::exists(cases)) {
    GTEST_SKIP() << cases << " is not there";
  }
  for (const auto& entry : std::filesystem::directory_iterator(cases)) {
    if (!entry.is_directory()) continue;
    const TestBundle bundle = read_test_bundle(entry.path());
    const HitSet hits = find_hits(bundle, read_recordings(bundle), {});
    for (const std::vector<Hit>& run : hits.runs) {
      ASSERT_EQ(run.size(), 3U) << entry.path();
      for (const Hit& hit : run) {
        EXPECT_TRUE(hit.accepted || reasons(hit) == "double ")
            << entry.path() << " " << reasons(hit);
      }
    }
  }
}

// A file for each hit: they are judged against each other as in one file.
TEST(FindHits, ComparesHitsOfRunsAtTheSamePoints) {
  std::vector<Recording> recordings;
  for (unsigned k = 0; k < 5; ++k) {
    Scene scene;
    scene.length_s = 5.0;
    scene.blows = {{1.0, 20.0 + k}};
    recordings.push_back(record(scene, k + 1));
  }
  recordings[2].samples.col(1) *= 3.0;
  const HitSet hits = find(recordings);
  for (std::size_t r = 0; r < 5; ++r) {
    ASSERT_EQ(hits.runs[r].size(), 1U);
    EXPECT_EQ(blames(hits.runs[r][0], HitFault::Outlier), r == 2);
  }
  // It is not kept as the best of its file: there are better ones.
  const auto said = std::ranges::count_if(hits.statements, [](const auto& s) {
    return s.find("others at the same points are") != std::string::npos;
  });
  EXPECT_EQ(said, 1);

  // Elsewhere it may be as it is.
  TestBundle bundle = testing::hammer_bundle(5);
  bundle.band_hz = {5.0, 200.0};
  bundle.runs[2].hammer.dof.node += 1;
  EXPECT_TRUE(find_hits(bundle, recordings, {}).runs[2][0].accepted);
}

}  // namespace
}  // namespace tapfit::acquisition
