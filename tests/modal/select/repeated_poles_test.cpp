// Modes that share one pole: a square plate has them, and no fit of distinct
// poles can hold them.
#include "modal/identify/identify_modes.hpp"
#include "modal/mode_set/mac.hpp"
#include "tests/modal/support/close_modes.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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
      for (unsigned seed = 1; seed <= 6; ++seed) {
        std::mt19937_64 random(400 + seed);
        const test::SyntheticSystem system =
            test::close_modes(2, apart, random);
        const modal::ModeSet set = identify(system, {0, 1}, noise, random);
        const bool good =
            set.modes.size() == 2 && alignment(system, set) > 0.95;
        right += good ? 1 : 0;
      }
      EXPECT_GE(right, 5) << apart << ' ' << noise;
    }
  }
}

/// The same FRFs with hits and sensors in each other's place, all sensors on at
/// each hit.
signal::FrfSet turned_round(signal::FrfSet set) {
  for (signal::Frf& frf : set.frfs) {
    std::swap(frf.response, frf.reference);
    frf.run = static_cast<std::size_t>(frf.reference.node);
  }
  return set;
}

TEST(RepeatedPoles, AreFoundFromFixedHitsToo) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(30 + seed);
    const test::SyntheticSystem system = test::close_modes(2, 0.0, random);
    const modal::ModeSet set = modal::identify_modes(
        turned_round(test::close_modes_frfs(system, {0, 1}, 0.01, random)), {});
    ASSERT_EQ(set.modes.size(), 2U) << seed;
    EXPECT_GT(alignment(system, set), 0.95) << seed;
    // The basis is orthogonal over all points.
    EXPECT_LT(modal::mac(set.modes[0].shape, set.modes[1].shape)(0, 0), 0.01);
  }
}

// Two shapes, of which only one is scaled: neither can be told.
TEST(RepeatedPoles, SayThatTheyCannotBeTakenApart) {
  std::mt19937_64 random(8);
  const test::SyntheticSystem system = test::close_modes(2, 0.0, random);
  signal::FrfSet set = test::close_modes_frfs(system, {0, 1}, 0.01, random);
  std::erase_if(set.frfs, [](const signal::Frf& frf) {
    return frf.response.node == frf.reference.node && frf.response.node == 2;
  });
  const modal::ModeSet found = modal::identify_modes(set, {});
  EXPECT_TRUE(std::ranges::any_of(found.warnings, [](const auto& warning) {
    return warning.find("cannot be taken apart") != std::string::npos;
  }));
}

// What is left of a mode that was dropped is no second shape of the next one.
TEST(RepeatedPoles, AreNotMadeOfAMissedNeighbour) {
  std::mt19937_64 random(5);
  test::SyntheticSystem system = test::close_modes(2, 0.05, random);
  modal::IdentifyOptions options;
  options.edits = {{modal::PoleEdit::What::Drop, 50.0}};
  const modal::ModeSet set = modal::identify_modes(
      test::close_modes_frfs(system, {0, 1}, 0.01, random), options);
  EXPECT_EQ(set.modes.size(), 1U);
}

// Bandwidths up to the distance to the next mode: none may be taken for one
// with its neighbour.
TEST(RepeatedPoles, HeavilyDampedModesStayApart) {
  int right = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(60 + seed);
    test::SyntheticSystem system;
    system.frequency_hz.resize(4);
    system.frequency_hz << 60.0, 100.0, 150.0, 190.0;
    system.damping_ratio = Eigen::VectorXd::Constant(4, 0.1);
    system.phi = test::random_shapes(25, 4, random);
    const Eigen::VectorXcd s = test::line_points(35, 240, 821, 0.0);
    const modal::ModeSet set = modal::identify_modes(
        test::roving_hammer(system, {7, 9}, s, 0.02, random), {});
    bool good = set.modes.size() == 4;
    for (std::size_t k = 0; good && k < 4; ++k) {
      const double f = system.frequency_hz(static_cast<Index>(k));
      good = std::abs(set.modes[k].frequency_hz / f - 1.0) < 0.005 &&
             std::abs(set.modes[k].damping_ratio / 0.1 - 1.0) < 0.05;
    }
    right += good ? 1 : 0;
  }
  // Some shapes hardly move the two references: a mode stays hidden there.
  EXPECT_GE(right, 7);
}

// A third mode beside a pair takes none of its shapes away: from a fifth of a
// bandwidth on.
TEST(RepeatedPoles, APairBesideAThirdModeStaysAPair) {
  for (const double half_bandwidths : {0.4, 1.0, 2.0}) {
    int right = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
      std::mt19937_64 random(700 + seed);
      test::SyntheticSystem system = test::close_modes(3, 0.0, random);
      system.frequency_hz(2) *= 1.0 + 0.008 * half_bandwidths;
      const modal::ModeSet set = identify(system, {0, 1, 2}, 0.02, random);
      const bool good = set.modes.size() == 3 && alignment(system, set) > 0.95;
      right += good ? 1 : 0;
    }
    EXPECT_GE(right, 5) << half_bandwidths;
  }
}

// Six modes whose bandwidths are about their distances: a high order spends
// its poles on the noise, a low one finds them.
TEST(RepeatedPoles, OverlappingModesAreFoundAtLowOrders) {
  int right = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937_64 random(3000 + seed);
    const test::SyntheticSystem system =
        test::random_system(6, 25, 0.1, 0.1, random);
    const Eigen::VectorXcd s = test::line_points(5, 100, 381, 0.0);
    const modal::ModeSet set = modal::identify_modes(
        test::roving_hammer(system, {7, 9}, s, 0.01, random), {});
    bool good = set.modes.size() == 6;
    for (std::size_t k = 0; good && k < 6; ++k) {
      const double f = system.frequency_hz(static_cast<Index>(k));
      good = std::abs(set.modes[k].frequency_hz / f - 1.0) < 0.01;
    }
    right += good ? 1 : 0;
  }
  EXPECT_GE(right, 7);
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
