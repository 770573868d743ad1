// Channels of a run that hold one signal.
#include "acquisition/checks/repeated_runs.hpp"
#include "tests/acquisition/support/hammer_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tapfit::acquisition {
namespace {

// Of a 16-bit converter: noise over 6000 steps.
Eigen::VectorXd recorded(unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd x(2000);
  for (double& value : x) value = std::round(6000.0 * normal(engine)) / 32768.0;
  return x;
}

struct TwoSensors {
  TestBundle bundle = testing::hammer_bundle();
  std::vector<Recording> recordings{1};

  TwoSensors() {
    bundle.channels.resize(2);
    bundle.channels.push_back(bundle.channels[1]);
    bundle.channels[2].name = "acc2";
    bundle.runs.resize(1);
    bundle.runs[0].sensors.resize(1);
    bundle.runs[0].sensors.push_back({2, Dof{3, 3, 1}});
    recordings[0].samples.resize(2000, 3);
    for (int c = 0; c < 3; ++c) {
      recordings[0].samples.col(c) = recorded(7U + static_cast<unsigned>(c));
    }
  }
};

TEST(RepeatedChannels, OwnSignalsAreNone) {
  const TwoSensors test;
  EXPECT_TRUE(repeated_channel_findings(test.bundle, test.recordings).empty());
}

// Two accelerometers side by side differ by their noise: 20 steps.
TEST(RepeatedChannels, NeighboursAreNone) {
  TwoSensors test;
  test.recordings[0].samples.col(2) =
      test.recordings[0].samples.col(1) + 20.0 / 6000.0 * recorded(20);
  EXPECT_TRUE(repeated_channel_findings(test.bundle, test.recordings).empty());
}

// The other input has another range and sensitivity.
TEST(RepeatedChannels, OneSignalIsFoundWhateverItsScale) {
  TwoSensors test;
  const Eigen::VectorXd scaled = test.recordings[0].samples.col(1) * 0.37;
  test.recordings[0].samples.col(2) =
      9.81 * (scaled * 32768.0).array().round() / 32768.0;
  const std::vector<Finding> said =
      repeated_channel_findings(test.bundle, test.recordings);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].where.channel, "acc2");
  EXPECT_NE(said[0].what.find("hold the same signal"), std::string::npos);
}

}  // namespace
}  // namespace tapfit::acquisition
