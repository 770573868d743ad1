#include "modal/checks/sensor_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

// From 20 Hz on, each half as high again, with one percent of damping.
Eigen::VectorXcd poles_of(Index modes) {
  Eigen::VectorXcd poles(modes);
  for (Index k = 0; k < modes; ++k) {
    const double omega = 125.0 * std::pow(1.5, static_cast<double>(k));
    poles(k) = omega * std::complex<double>(-0.01, 1.0);
  }
  return poles;
}

// Shapes at the sensors times what each run's point excites, with noise of one
// in a thousand. Of the first mode the late runs see most, of the others
// little: a share.
SensorSetUp test_of(Index modes, unsigned seed, double little = 0.1) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  MatrixXcd shapes(sensors, modes);
  for (auto& value : shapes.reshaped()) value = normal(engine);
  SensorSetUp set_up;
  for (std::size_t r = 0; r < runs; ++r) {
    Eigen::VectorXd excited(modes);
    for (double& q : excited) q = 1.0 + 0.5 * normal(engine);
    (r < first_changed ? excited.head(1) : excited.tail(modes - 1)) *= little;
    MatrixXcd z = shapes * excited.asDiagonal();
    for (auto& value : z.reshaped()) {
      value += 1e-3 * std::complex<double>(normal(engine), normal(engine));
    }
    set_up.channels = {1, 2, 3};
    set_up.poles = poles_of(modes);
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

// Integrated, differentiated, and late by 3 ms.
TEST(SensorPatterns, OfASensorThatMeasuredAnotherQuantityFollowItsLaw) {
  constexpr Index modes = 5;
  const SensorLaw laws[] = {{-1, 0.0},
                            {-1, 1e-4},
                            {-2, 0.0},
                            {1, 0.0},
                            {2, 0.0},
                            {0, 3e-3},
                            {0, -3e-3}};
  for (const SensorLaw& law : laws) {
    SensorSetUp test = test_of(modes, 5, 1.0);
    const double size = law.power == 0 ? 1.0 : 0.7;
    scale_sensor(test, 1, size * law.factors(poles_of(modes)).transpose());
    const std::vector<SensorPattern> all = compare_patterns(test, {});
    for (std::size_t r = first_changed; r < runs; ++r) {
      const SensorPattern& p = all[r];
      EXPECT_EQ(p.sensor, 1U) << r;
      EXPECT_EQ(p.law.power, law.power) << r;
      EXPECT_NEAR(p.law.delay_s, law.delay_s, 2e-5) << r;
      EXPECT_NEAR(p.factor.real(), size, 0.02) << r;
      EXPECT_LT(p.scatter, RunResidueLimits{}.scatter) << r;
    }
  }
}

// Real factors of any size for each mode are those of another point.
TEST(SensorPatterns, OfASensorThatMovedFollowNoLaw) {
  constexpr Index modes = 4;
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    SensorSetUp test = test_of(modes, 6);
    MatrixXcd factors(1, modes);
    for (auto& value : factors.reshaped()) value = normal(engine);
    scale_sensor(test, 1, factors);
    const std::vector<SensorPattern> all = compare_patterns(test, {});
    for (std::size_t r = first_changed; r < runs; ++r) {
      EXPECT_TRUE(all[r].law.is_plain()) << trial;
    }
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
