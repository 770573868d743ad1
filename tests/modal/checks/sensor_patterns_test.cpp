#include "modal/checks/sensor_patterns.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr Index sensors = 3;
constexpr std::size_t runs = 8;
constexpr std::size_t first_changed = 5;

// Shapes at the sensors times what each run's point excites, with noise of one
// in a thousand. Of the first mode the late runs see most, of the others
// little.
SensorSetUp test_of(Index modes, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  MatrixXcd shapes(sensors, modes);
  for (auto& value : shapes.reshaped()) value = normal(engine);
  SensorSetUp set_up;
  for (std::size_t r = 0; r < runs; ++r) {
    Eigen::VectorXd excited(modes);
    for (double& q : excited) q = 1.0 + 0.5 * normal(engine);
    (r < first_changed ? excited.head(1) : excited.tail(modes - 1)) *= 0.1;
    MatrixXcd z = shapes * excited.asDiagonal();
    for (auto& value : z.reshaped()) {
      value += 1e-3 * std::complex<double>(normal(engine), normal(engine));
    }
    set_up.channels = {1, 2, 3};
    set_up.runs.push_back(r);
    set_up.z.push_back(std::move(z));
    set_up.sd.push_back(MatrixXd::Constant(sensors, modes, 1e-3));
  }
  return set_up;
}

void scale_sensor(SensorSetUp& test, Index sensor, const MatrixXcd& factors) {
  for (std::size_t r = first_changed; r < runs; ++r) {
    test.z[r].row(sensor).array() *= factors.row(0).array();
  }
}

TEST(SensorPatterns, AreTheSameWhateverIsHit) {
  for (const SensorPattern& p : compare_patterns(test_of(4, 1), {})) {
    EXPECT_LT(p.error, RunResidueLimits{}.much);
    EXPECT_NEAR(std::abs(p.factor), 1.0, 0.05);
  }
}

// Though they are strongest where the first mode is concerned.
TEST(SensorPatterns, OfRunsWhoseRangeWasChangedDifferByOneFactor) {
  for (const Index modes : {2, 4}) {
    SensorSetUp test = test_of(modes, 2);
    scale_sensor(test, 1, MatrixXcd::Constant(1, modes, 3.16));
    const std::vector<SensorPattern> all = compare_patterns(test, {});
    for (std::size_t r = 0; r < runs; ++r) {
      const SensorPattern& p = all[r];
      if (r < first_changed) {
        EXPECT_LT(p.error, RunResidueLimits{}.much) << r;
        continue;
      }
      EXPECT_GT(p.error, 2.0 * RunResidueLimits{}.much) << r;
      EXPECT_EQ(p.sensor, 1U) << r;
      EXPECT_NEAR(p.factor.real(), 3.16, 0.1) << r;
      EXPECT_LT(p.scatter, RunResidueLimits{}.scatter) << r;
    }
  }
}

// The factor of the strong mode explains nearly all: only the modes, each by
// itself, tell that there is no common one.
TEST(SensorPatterns, OfASensorThatMovedHaveNoCommonFactor) {
  SensorSetUp test = test_of(2, 3);
  scale_sensor(test, 1, MatrixXcd{{-0.5, -0.7}});
  const std::vector<SensorPattern> all = compare_patterns(test, {});
  for (std::size_t r = first_changed; r < runs; ++r) {
    EXPECT_EQ(all[r].sensor, 1U) << r;
    EXPECT_LT(all[r].left, RunResidueLimits{}.one_factor * all[r].error) << r;
    EXPECT_EQ(all[r].modes, 2) << r;
    EXPECT_GT(all[r].scatter, RunResidueLimits{}.scatter) << r;
  }
}

TEST(SensorPatterns, OfOneModeDoNotTellAChangedRangeFromAMove) {
  SensorSetUp test = test_of(1, 4);
  scale_sensor(test, 1, MatrixXcd::Constant(1, 1, 3.16));
  for (const SensorPattern& p : compare_patterns(test, {})) {
    EXPECT_LE(p.modes, 1);
    EXPECT_LT(p.scatter, RunResidueLimits{}.scatter);
  }
}

TEST(SensorPatterns, AreUsualWhereThreeQuartersAreWorse) {
  Eigen::VectorXd errors(8);
  errors << 0.5, 0.01, 0.6, 0.02, 0.7, 0.03, 0.5, 0.01;
  EXPECT_DOUBLE_EQ(usual_limit(errors, {}), 6.0 * 0.02);
  EXPECT_DOUBLE_EQ(usual_limit(0.1 * errors, {}), 0.03);
}

}  // namespace
}  // namespace tapfit::modal
