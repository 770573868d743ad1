// Modes that share one pole: a square plate has them, and no fit of distinct
// poles can hold them.
#include "modal/identify_modes.hpp"
#include "tests/modal/close_modes.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tapfit {
namespace {

using Eigen::Index;

modal::ModeSet identify(const test::SyntheticSystem& system,
                        const std::vector<Index>& sensors,
                        double noise,
                        std::mt19937_64& random) {
  return modal::identify_modes(
      test::close_modes_frfs(system, sensors, noise, random), {});
}

/// Smallest cosine between the space of true shapes and that of the found.
double alignment(const test::SyntheticSystem& system,
                 const modal::ModeSet& set) {
  Eigen::MatrixXd found(system.phi.rows(), system.phi.cols());
  for (Index k = 0; k < found.cols(); ++k) {
    found.col(k) = set.modes[static_cast<std::size_t>(k)].shape.real();
  }
  const auto basis = [](const Eigen::MatrixXd& shapes) {
    return Eigen::MatrixXd(
        Eigen::HouseholderQR<Eigen::MatrixXd>(shapes).householderQ() *
        Eigen::MatrixXd::Identity(shapes.rows(), shapes.cols()));
  };
  return Eigen::JacobiSVD<Eigen::MatrixXd>(basis(system.phi).transpose() *
                                           basis(found))
      .singularValues()
      .minCoeff();
}

bool says_so(const modal::ModeSet& set) {
  return std::ranges::any_of(set.warnings, [](const std::string& warning) {
    return warning.find("share the pole at 50 Hz") != std::string::npos;
  });
}

// Without noise the shapes' sum of products is exact: phi phi' = sum over the
// true ones, whatever basis they come in.
TEST(RepeatedPoles, KeepTheirNumberSpaceAndScale) {
  std::mt19937_64 random(11);
  for (const Index count : {2, 3}) {
    const test::SyntheticSystem system = test::close_modes(count, 0.0, random);
    const modal::ModeSet set = identify(system, {0, 1, 2}, 0.0, random);
    ASSERT_EQ(static_cast<Index>(set.modes.size()), count);
    EXPECT_TRUE(says_so(set));
    ASSERT_TRUE(set.scaled);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(16, 16);
    for (const modal::Mode& mode : set.modes) {
      EXPECT_NEAR(mode.frequency_hz, 50.0, 1e-6);
      EXPECT_NEAR(mode.damping_ratio, 0.008, 1e-8);
      sum += mode.shape.real() * mode.shape.real().transpose();
    }
    const Eigen::MatrixXd truth = system.phi * system.phi.transpose();
    EXPECT_LT((sum - truth).norm(), 1e-5 * truth.norm()) << count;
  }
}

TEST(RepeatedPoles, AreFoundInNoise) {
  for (const double noise : {0.01, 0.05}) {
    int right = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::mt19937_64 random(900 + seed);
      const test::SyntheticSystem system = test::close_modes(2, 0.0, random);
      const modal::ModeSet set = identify(system, {0, 1}, noise, random);
      const bool good =
          set.modes.size() == 2 &&
          std::abs(set.modes[0].frequency_hz / 50.0 - 1.0) < 1e-3 &&
          std::abs(set.modes[1].frequency_hz / 50.0 - 1.0) < 1e-3 &&
          alignment(system, set) > 0.95;
      right += good ? 1 : 0;
    }
    EXPECT_GE(right, 19) << noise;
  }
}

// However near, told apart or under one pole, two modes stay two.
TEST(RepeatedPoles, PairsAtAnyDistanceAreTwoModes) {
  for (const double apart : {1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2}) {
    for (const double noise : {0.002, 0.05}) {
      int right = 0;
      for (unsigned seed = 1; seed <= 10; ++seed) {
        std::mt19937_64 random(400 + seed);
        const test::SyntheticSystem system =
            test::close_modes(2, apart, random);
        const modal::ModeSet set = identify(system, {0, 1}, noise, random);
        const bool good =
            set.modes.size() == 2 && alignment(system, set) > 0.95;
        right += good ? 1 : 0;
      }
      EXPECT_GE(right, 9) << apart << ' ' << noise;
    }
  }
}

TEST(RepeatedPoles, OneModeIsNeverTwo) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937_64 random(seed);
    const double noise = 0.004 * seed;  // up to 20 %
    const modal::ModeSet set =
        identify(test::close_modes(1, 0.0, random), {0, 1, 2}, noise, random);
    EXPECT_EQ(set.modes.size(), 1U) << seed;
  }
}

}  // namespace
}  // namespace tapfit
