// Two sensors that ring after each blow, of which one drifts or hears nothing.
#include "acquisition/checks/blow_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double drift_rate = 256.0;
constexpr Index drift_block = 1024;
constexpr int drift_blows = 3;

struct Rung {
  TestBundle bundle;
  std::vector<Recording> recordings;
  HitSet hits;
};

Rung ringing_test() {
  Rung test;
  test.bundle.channels.resize(3);
  test.bundle.channels[1].name = "acc1";
  test.bundle.channels[2].name = "acc2";
  test.bundle.runs.resize(1);
  test.bundle.runs[0].sensors = {{1, {}}, {2, {}}};
  test.hits.sample_rate_hz = drift_rate;
  test.hits.block = drift_block;
  test.hits.runs.resize(1);
  std::mt19937 engine(1);
  std::normal_distribution<double> noise(0.0, 1e-3);
  Eigen::MatrixXd x(drift_block * (drift_blows + 1), 3);
  for (double& value : x.reshaped()) value = noise(engine);
  for (int k = 0; k < drift_blows; ++k) {
    Hit hit;
    hit.trigger = drift_block * k + drift_block / 2;
    hit.pulse_s = 0.01;
    for (Index i = hit.trigger; i < hit.trigger + drift_block; ++i) {
      const double t = static_cast<double>(i - hit.trigger) / drift_rate;
      const double ring = std::exp(-3.0 * t) * std::sin(120.0 * t);
      x(i, 1) += ring;
      x(i, 2) += 0.5 * ring;
    }
    test.hits.runs[0].push_back(hit);
  }
  test.recordings.resize(1);
  test.recordings[0].samples = x;
  test.recordings[0].sample_rate_hz = drift_rate;
  return test;
}

std::vector<Finding> findings_of(const Rung& test) {
  return blow_response_findings(
      test.bundle, blow_responses(test.bundle, test.recordings, test.hits));
}

TEST(BlowResponse, OfAFairTestIsNoFinding) {
  EXPECT_TRUE(findings_of(ringing_test()).empty());
}

// A ramp of three times its largest value over the record.
TEST(BlowResponse, IsHeardByASensorThatDrifts) {
  Rung test = ringing_test();
  auto x = test.recordings[0].samples.col(2);
  x += Eigen::VectorXd::LinSpaced(x.size(), 0.0, 3.0 * x.maxCoeff());
  EXPECT_TRUE(findings_of(test).empty());
}

TEST(BlowResponse, IsNotHeardByOneWhoseCableIsOff) {
  Rung test = ringing_test();
  std::mt19937 engine(2);
  std::normal_distribution<double> noise(0.0, 0.1);
  auto x = test.recordings[0].samples.col(2);
  for (double& value : x) value = noise(engine);
  x += Eigen::VectorXd::LinSpaced(x.size(), 0.0, 3.0);  // though it drifts
  const std::vector<Finding> found = findings_of(test);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].where.channel, "acc2");
}

}  // namespace
}  // namespace tapfit::acquisition
