// What second blows cost, against the closed form of two equal pulses:
// F = F_1 (1 + p exp(-j w t)), its dips 1 - p of F_1 at w t = pi, 3 pi, ...
#include "acquisition/hits/double_hits.hpp"

#include "acquisition/hits/find_hits.hpp"
#include "tests/acquisition/support/hit_scene.hpp"
#include "tests/support/matchers.hpp"

#include <cmath>

namespace tapfit::acquisition {
namespace {

using testing::blames;
using testing::find;
using testing::reasons;
using testing::record;
using testing::Scene;

// The second of four blows, of 30 N, is double.
Hit with_second(double share, double after_s, double decay = 2.0) {
  Scene scene;
  scene.decay = decay;
  scene.blows.push_back({5.0 + after_s, 30.0 * share});
  const HitSet hits = find({record(scene)});
  return hits.runs[0].at(1);
}

TEST(DoubleHit, CostsWhatItsDipsTake) {
  for (const double share : {0.05, 0.1, 0.3, 0.6, 0.8}) {
    const Hit hit = with_second(share, 0.02);
    ASSERT_TRUE(hit.second) << share;
    // The record's pulses are four samples wide, at different phases.
    EXPECT_NEAR(hit.second->share, share, 0.05 * share + 0.002);
    EXPECT_NEAR(hit.second->after_s, 0.02, 0.5 / 2048.0);
    // Dips every 50 Hz of 5 to 200: the deepest where the pulse's own spectrum
    // is lowest, at 175 Hz and not at 200, which is 0.5 dB lower.
    EXPECT_NEAR(
        hit.second->loss_db, -20.0 * std::log10(1.0 - share), 0.6 + share)
        << share;
    EXPECT_TRUE(hit.accepted) << share;
    EXPECT_EQ(reasons(hit), "double ");
  }
}

// exp(-2 (3 - 0.02)) of it is left at the end of a block of six time constants.
TEST(DoubleHit, LeavesOutsideWhatHasNotDecayed) {
  Scene scene;
  scene.blows.push_back({5.02, 15.0});
  const HitSet hits = find({record(scene)});
  const Hit& hit = hits.runs[0][1];
  ASSERT_TRUE(hit.second);
  const double rest_s =
      static_cast<double>(hits.block - hits.pre_trigger) / scene.rate - 0.02;
  // The decay is read from a record with noise: to 10 %.
  EXPECT_NEAR(std::log(hit.second->outside),
              std::log(1.0 / 3.0) - 2.0 * rest_s,
              0.2 * rest_s);
  EXPECT_FALSE(hit.second->leaves_block);
}

TEST(DoubleHit, WithoutForceAtSomeLinesIsOutUnlessThereIsNoOther) {
  EXPECT_TRUE(blames(with_second(0.97, 0.02), HitFault::Double));
  Scene scene;
  scene.blows = {{2.0, 20.0}, {2.02, 20.0}};
  const HitSet hits = find({record(scene)});
  ASSERT_EQ(hits.runs[0].size(), 1U);
  EXPECT_TRUE(hits.runs[0][0].second->thins_force);
  EXPECT_TRUE(hits.runs[0][0].accepted);
  EXPECT_THAT(hits.statements.back(), HasSubstr("kept"));
}

// Behind 3 of 3.2 s hardly anything of the second response is in the block,
// though in all its octaves it decays within.
TEST(DoubleHit, TooLateForItsResponseIsOut) {
  HitOptions options;
  options.block_s = 3.2;
  Scene scene;
  scene.blows.push_back({8.0, 3.0});
  const HitSet hits = find({record(scene)}, options);
  const Hit& hit = hits.runs[0].at(1);
  ASSERT_TRUE(hit.second);
  EXPECT_TRUE(hit.second->leaves_block);
  EXPECT_TRUE(blames(hit, HitFault::Double));
}

// Below 5 % it is force like any other, and no double hit.
TEST(DoubleHit, SmallSecondBlowsAreForceAndNoMore) {
  const Hit hit = with_second(0.02, 0.6);
  ASSERT_TRUE(hit.second);
  EXPECT_TRUE(hit.accepted);
  EXPECT_EQ(reasons(hit), "");
  EXPECT_GT(hit.blows_after, static_cast<Eigen::Index>(0.6 * 2048.0));
  EXPECT_LT(hit.blows_after, static_cast<Eigen::Index>(0.62 * 2048.0));
}

TEST(DoubleHit, StatementsSayHowManyAndWhatTheyCost) {
  Scene scene;
  scene.blows.push_back({5.02, 15.0});
  scene.blows.push_back({9.02, 24.5});
  const HitSet hits = find({record(scene)});
  const std::vector<std::string> said = double_statements(hits);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_THAT(said[0], HasSubstr("1 double hit is not rejected"));
  EXPECT_THAT(said[0], HasSubstr("50 % of the main blow, 20 ms"));
  EXPECT_THAT(said[1], HasSubstr("too little force"));
}

}  // namespace
}  // namespace tapfit::acquisition
