// Sensors at one grid and direction see one motion.
#include "acquisition/checks/one_point.hpp"

#include "tests/acquisition/support/hammer_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tapfit::acquisition {
namespace {

// What rings after a hit, behind a quiet quarter, with noise of a hundredth.
Eigen::VectorXd rung(double frequency, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0.0, 0.01);
  Eigen::VectorXd x(2000);
  for (int k = 0; k < 2000; ++k) {
    const int since = k - 500;
    x[k] = noise(engine);
    if (since >= 0) {
      x[k] += std::exp(-0.005 * since) * std::sin(frequency * since);
    }
  }
  return x;
}

struct TwoAtOnePoint {
  TestBundle bundle = testing::hammer_bundle();
  std::vector<Recording> recordings{1};

  explicit TwoAtOnePoint(const Eigen::VectorXd& second, int sign = 1) {
    bundle.channels.resize(2);
    bundle.channels.push_back(bundle.channels[1]);
    bundle.channels[2].name = "acc2";
    bundle.runs.resize(1);
    bundle.runs[0].sensors.resize(1);
    Placement other = bundle.runs[0].sensors[0];
    other.channel = 2;
    other.dof.sign *= sign;
    bundle.runs[0].sensors.push_back(other);
    recordings[0].samples.resize(2000, 3);
    recordings[0].samples.col(0) = rung(1.0, 1);
    recordings[0].samples.col(1) = rung(0.2, 2);
    recordings[0].samples.col(2) = second;
  }
  [[nodiscard]] std::vector<Finding> said() const {
    return one_point_findings(bundle, recordings);
  }
};

TEST(OnePoint, TwoSensorsThatAgreeAreFine) {
  EXPECT_TRUE(TwoAtOnePoint(1.2 * rung(0.2, 3)).said().empty());
  EXPECT_TRUE(TwoAtOnePoint(-rung(0.2, 3), -1).said().empty());
}

TEST(OnePoint, SignalsThatDifferAreNamed) {
  const std::vector<Finding> other = TwoAtOnePoint(rung(0.13, 3)).said();
  ASSERT_EQ(other.size(), 1U);
  EXPECT_EQ(other[0].where.channel, "acc2");
  EXPECT_EQ(other[0].where.runs, std::vector<std::size_t>{0});
  EXPECT_NE(other[0].what.find("hold different signals"), std::string::npos);
  const std::vector<Finding> turned = TwoAtOnePoint(-rung(0.2, 3)).said();
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_NE(turned[0].what.find("against each other"), std::string::npos);
  const std::vector<Finding> gain = TwoAtOnePoint(9.81 * rung(0.2, 3)).said();
  ASSERT_EQ(gain.size(), 1U);
  EXPECT_NE(gain[0].what.find("a factor of 9.8"), std::string::npos);
}

TEST(OnePoint, OtherPointsAndQuantitiesMayDiffer) {
  TwoAtOnePoint test(rung(0.13, 3));
  test.bundle.channels[2].quantity = Quantity::Velocity;
  EXPECT_TRUE(test.said().empty());
  test.bundle.channels[2].quantity = test.bundle.channels[1].quantity;
  test.bundle.runs[0].sensors[1].dof.node += 1;
  EXPECT_TRUE(test.said().empty());
}

}  // namespace
}  // namespace tapfit::acquisition
