// Settings and recordings that falsify hits are warned of, and only these.
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/hits/hits.hpp"
#include "tests/acquisition/support/hammer_record.hpp"
#include "tests/support/matchers.hpp"

namespace tapfit::acquisition {
namespace {

constexpr double rate = 2048.0;

// Four blows, 4 s apart, of 20 to 35 N and 4 ms; each undershoots by a tenth
// as behind a high-pass, and a mode rings after it.
Recording record(double sign) {
  std::mt19937_64 random(5);
  Recording recording;
  recording.sample_rate_hz = rate;
  recording.samples.setZero(static_cast<Eigen::Index>(17.0 * rate), 2);
  Eigen::VectorXd force = recording.samples.col(0);
  Eigen::VectorXd response = force;
  for (int k = 0; k < 4; ++k) {
    const double at = 1.0 + 4.0 * k;
    const double peak = 20.0 + 5.0 * k;
    testing::add_pulse(force, rate, at, 4e-3, sign * peak, true);
    testing::add_pulse(force, rate, at + 6e-3, 8e-3, -0.1 * sign * peak, false);
    testing::add_response(response, rate, at, 60.0, 2.0, peak);
  }
  testing::add_noise(force, 1e-3, random);
  testing::add_noise(response, 1e-3, random);
  recording.samples << force, response;
  return recording;
}

HitSet find(const HitOptions& options, double sign = 1.0) {
  TestBundle bundle = testing::hammer_bundle();
  bundle.band_hz = {5.0, 200.0};
  return find_hits(bundle, {record(sign)}, options);
}

// One warning that begins so, among the statements too.
void expect_warning(const HitSet& hits, const std::string& begins) {
  ASSERT_EQ(hits.findings.size(), 1U) << begins;
  EXPECT_TRUE(in_full(hits.findings[0]).starts_with(begins))
      << in_full(hits.findings[0]);
  EXPECT_EQ(std::ranges::count(hits.statements, in_full(hits.findings[0])), 1);
}

TEST(HitWarnings, OrdinaryHitsHaveNone) {
  EXPECT_TRUE(find({}).findings.empty());
  HitOptions options;
  options.block_s = 3.5;
  options.pre_trigger_s = 0.05;
  options.trigger.slope = 1;
  EXPECT_TRUE(find(options).findings.empty());
  options.trigger.slope = -1;
  EXPECT_TRUE(find(options, -1.0).findings.empty());
}

TEST(HitWarnings, BlowsThatAreNegative) {
  expect_warning(find({}, -1.0), "blows are negative");
}

TEST(HitWarnings, ASlopeThatBlowsDoNotHave) {
  HitOptions options;
  options.trigger.slope = -1;
  const HitSet hits = find(options);
  expect_warning(hits, "trigger_slope is \"falling\"");
  options.trigger.slope = 1;
  expect_warning(find(options, -1.0), "trigger_slope is \"rising\"");
}

TEST(HitWarnings, APreTriggerWithinTheRise) {
  HitOptions options;
  options.pre_trigger_s = 0.0;
  expect_warning(find(options), "pre_trigger_s of 0 s is shorter than a pulse");
  options.pre_trigger_s = 0.01;
  EXPECT_TRUE(find(options).findings.empty());
}

TEST(HitWarnings, ABlockThatHoldsTheNextBlow) {
  HitOptions options;
  options.block_s = 6.0;
  const HitSet hits = find(options);
  expect_warning(hits, "block_s of 6 s is longer than the time to the next");
  EXPECT_THAT(in_full(hits.findings[0]),
              HasSubstr("3 of 4 hits (4 s at the least)"));
}

}  // namespace
}  // namespace tapfit::acquisition
