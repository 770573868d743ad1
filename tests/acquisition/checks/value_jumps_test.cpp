// Records of decays whose parts do or do not fit together.
#include "acquisition/checks/value_jumps.hpp"

#include "tests/acquisition/support/hammer_record.hpp"
#include "tests/support/matchers.hpp"

#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double rate = 2048.0;

// Blows at 1, 4 and 7 s on three modes, seen by two sensors; the highest is
// sampled five times a period.
Recording ringing(unsigned seed, double noise) {
  std::mt19937_64 random(seed);
  Recording recording;
  recording.sample_rate_hz = rate;
  recording.samples = Eigen::MatrixXd::Zero(20480, 3);
  std::uniform_real_distribution<double> share(0.3, 1.0);
  for (Index c = 1; c < 3; ++c) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(20480);
    for (const double start : {1.0, 4.0, 7.0}) {
      for (const double hz : {31.0, 144.0, 410.0}) {
        testing::add_response(x, rate, start, hz, 1.0, share(random));
      }
    }
    for (Index i = 0; i < x.size(); ++i) {
      x(i) += 0.05 * std::sin(2.0 * std::numbers::pi * 50.0 / rate *
                              static_cast<double>(i));
    }
    testing::add_noise(x, noise, random);
    recording.samples.col(c) = x;
  }
  return recording;
}

std::vector<Hit> three_hits() {
  std::vector<Hit> hits(3);
  for (std::size_t k = 0; k < 3; ++k) {
    hits[k].time_s = 1.0 + 3.0 * static_cast<double>(k);
    hits[k].trigger = static_cast<Index>(hits[k].time_s * rate);
    hits[k].pulse_s = 2e-3;
  }
  return hits;
}

Run two_sensors() {
  Run run = testing::hammer_bundle().runs[0];
  run.sensors.push_back({2, Dof{3, 3, 1}});
  return run;
}

TEST(ValueJumps, OfSamplesLeftOutAreFoundWhereTheyAre) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Recording recording = ringing(seed, 1e-3);
    const Index at = 10000;
    const Index lost = 3 + static_cast<Index>(seed);
    const Index rest = recording.samples.rows() - at - lost;
    recording.samples.middleRows(at, rest) =
        recording.samples.bottomRows(rest).eval();
    const std::vector<Index> jumps =
        value_jumps(two_sensors(), recording, three_hits());
    ASSERT_EQ(jumps.size(), 1U) << seed;
    EXPECT_NEAR(static_cast<double>(jumps[0]), at, 2.0) << seed;
  }
}

// Where the response is loudest, soon after the blow at 4 s.
TEST(ValueJumps, OfSamplesLeftOutOfRingingAreFoundToo) {
  struct Cut {
    Index behind;  // the blow
    Index lost;
  };
  const auto blow = static_cast<Index>(4.0 * rate);
  for (const Cut& cut : {Cut{100, 37}, Cut{100, 200}, Cut{40, 3}}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      Recording recording = ringing(seed, 1e-3);
      const Index at = blow + cut.behind;
      const Index rest = recording.samples.rows() - at - cut.lost;
      recording.samples.middleRows(at, rest) =
          recording.samples.bottomRows(rest).eval();
      std::vector<Hit> hits = three_hits();
      hits[2].trigger -= cut.lost;
      const std::vector<Index> jumps =
          value_jumps(two_sensors(), recording, hits);
      ASSERT_EQ(jumps.size(), 1U) << cut.behind << " " << cut.lost;
      EXPECT_NEAR(static_cast<double>(jumps[0]), static_cast<double>(at), 2.0);
    }
  }
}

// A recorder that waits for its computer may write zeros.
TEST(ValueJumps, OfZerosPutInAreFound) {
  Recording recording = ringing(3, 1e-3);
  recording.samples.block(8400, 1, 50, 2).setZero();
  EXPECT_FALSE(value_jumps(two_sensors(), recording, three_hits()).empty());
}

TEST(ValueJumps, AreNoneInWholeRecords) {
  for (const double noise : {0.0, 1e-5, 1e-3, 0.1}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      EXPECT_TRUE(value_jumps(two_sensors(), ringing(seed, noise), three_hits())
                      .empty())
          << seed << " " << noise;
    }
  }
}

// A spike in one cable is none of the record's.
TEST(ValueJumps, AreNoneWhereOneSensorJumpsAlone) {
  Recording recording = ringing(1, 1e-3);
  recording.samples(10000, 1) += 0.5;
  EXPECT_TRUE(value_jumps(two_sensors(), recording, three_hits()).empty());
}

TEST(ValueJumps, AreSaidWithTheirTime) {
  TestBundle bundle = testing::hammer_bundle();
  bundle.runs[0] = two_sensors();
  Recording recording = ringing(2, 1e-3);
  recording.samples.bottomRows(10480) =
      recording.samples.bottomRows(10480).colwise().reverse().eval();
  HitSet hits;
  hits.runs = {three_hits()};
  const std::vector<Finding> found = jump_findings(bundle, {recording}, hits);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].what, HasSubstr("first at 4.883 s of run 1"));
}

}  // namespace
}  // namespace tapfit::acquisition
