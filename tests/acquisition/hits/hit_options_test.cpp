// What the options of finding hits do.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/hits/hammer_pulses.hpp"
#include "tests/acquisition/support/hit_scene.hpp"
#include "tests/support/matchers.hpp"

#include <limits>

namespace tapfit::acquisition {
namespace {

using testing::find;
using testing::record;
using testing::Scene;

TEST(HitOptions, OptionsAreObeyed) {
  HitOptions options;
  options.block_s = 1.5;
  options.pre_trigger_s = 0.25;
  options.trigger_percent = 60.0;  // of 30 N: only the blows of 20 N and more
  const HitSet hits = find({record({})}, options);
  EXPECT_EQ(hits.block, 3072);
  EXPECT_EQ(hits.pre_trigger, 512);
  EXPECT_EQ(hits.runs[0].size(), 3U);
}

TEST(HitOptions, ABlockTooShortForAPulseIsToldOf) {
  HitOptions options;
  options.block_s = 0.0005;  // one sample of 2048 Hz
  const HitSet hits = find({record({})}, options);
  EXPECT_GT(hits.block, hits.pre_trigger + 2);
  const auto says = [&](const char* part) {
    return std::any_of(hits.statements.begin(),
                       hits.statements.end(),
                       [&](const std::string& s) {
                         return s.find(part) != std::string::npos;
                       });
  };
  EXPECT_TRUE(says("not the 0.0005 s asked for"));
  EXPECT_FALSE(says(", as asked for"));
}

TEST(HitOptions, LevelMayBeGivenInPercentOfTheRange) {
  HitOptions options;
  options.trigger.range_percent = 4.4;  // of 500 N: 22 N
  const HitSet hits = find({record({})}, options);
  EXPECT_EQ(hits.runs[0].size(), 2U);
  EXPECT_DOUBLE_EQ(hits.trigger_n, 22.0);
  // 1 V/N: the same number of volts.
  EXPECT_THAT(hits.statements[0], HasSubstr("2.2e+04 mV, 4.4 % of the range"));
}

TEST(HitOptions, ALevelInPercentNeedsARange) {
  TestBundle bundle = testing::hammer_bundle();
  bundle.channels[0].full_scale_volts = std::numeric_limits<double>::infinity();
  bundle.trigger.range_percent = 4.0;
  EXPECT_THROW((void)find_hits(bundle, {record({})}, {}), InputError);
}

TEST(HitOptions, SlopeSaysWhichWayABlowGoes) {
  // Blows of 30 N, and before one of them a knock of 50 N the other way.
  Scene scene;
  scene.blows = {{2.0, 30.0}, {6.0, -50.0}, {10.0, 30.0}};
  HitOptions options;
  options.trigger_percent = 40.0;  // above the ringing of the knock's filter
  const Recording recording = record(scene);
  EXPECT_EQ(find({recording}, options).runs[0].size(), 1U);
  options.trigger.slope = 1;
  const HitSet hits = find({recording}, options);
  ASSERT_EQ(hits.runs[0].size(), 2U);
  EXPECT_NEAR(hits.runs[0][1].time_s, 10.0, 1e-3);
}

TEST(HitOptions, HysteresisKeepsAWobblingPulseWhole) {
  // A pulse of 30 N with a dent to 4 N: two with the trigger at 5 N armed
  // again below 4.5 N, one where it has to fall below 1 N.
  const double rate = 2048.0;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2048);
  testing::add_pulse(force, rate, 0.300, 20e-3, 30.0, false);
  testing::add_pulse(force, rate, 0.340, 20e-3, 30.0, false);
  force.segment(614, 84) = force.segment(614, 84).cwiseMax(4.0);
  EXPECT_EQ(find_pulses(force, piece_ranges(force), 5.0, 0.9).size(), 2U);
  EXPECT_EQ(find_pulses(force, piece_ranges(force), 5.0, 0.2).size(), 1U);
}

TEST(HitOptions, HoldOffJoinsWhatFollowsSoon) {
  HitOptions options;
  options.trigger.hold_off_s = 5.0;  // blows are 4 s apart
  const HitSet hits = find({record({})}, options);
  EXPECT_EQ(hits.runs[0].size(), 2U);
  EXPECT_EQ(hits.hold_off, 5 * 2048);
}

}  // namespace
}  // namespace tapfit::acquisition
