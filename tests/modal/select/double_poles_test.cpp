#include "modal/select/double_poles.hpp"

#include "acquisition/foundation/constants.hpp"
#include "modal/identify/identify_modes.hpp"
#include "modal/mode_set/mac.hpp"
#include "tests/modal/support/close_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit {
namespace {

using Eigen::Index;

modal::WeightedFrfs curves_of(const test::SyntheticSystem& system,
                              const std::vector<Index>& sensors,
                              double noise,
                              std::mt19937_64& random) {
  std::vector<std::string> warnings;
  return modal::prepare_frfs(
      test::close_modes_frfs(system, sensors, noise, random), warnings);
}

/// What expand_pole() finds under one pole fitted to all.
Eigen::VectorXcd found_under_one(const modal::WeightedFrfs& curves) {
  Eigen::VectorXcd one(1);
  one << std::complex<double>(-0.01, 1.0) * 50.0 * two_pi;
  const modal::ModalFit fit = modal::refine_poles(curves, one, 20);
  const modal::PoleExpansion expansion =
      modal::expand_pole(curves, modal::arrange_frfs(curves), fit, 0);
  return expansion.residues.rank < 2
             ? fit.poles
             : (expansion.apart.array() + fit.poles(0)).matrix().eval();
}

// 0.01 % apart, 1 % of the half bandwidth: the
// expansion's error is of second order in that, times a few for shapes that
// are not orthogonal.
TEST(DoublePoles, AreFoundFarBelowTheirBandwidth) {
  constexpr double separation = 1e-4;
  std::mt19937_64 random(1);
  for (const Index count : {2, 3}) {
    const test::SyntheticSystem system =
        test::close_modes(count, separation, random);
    const Eigen::VectorXcd found =
        found_under_one(curves_of(system, {0, 1, 2}, 0.0, random));
    ASSERT_EQ(found.size(), count);
    std::vector<double> hz;
    for (const auto& pole : found) hz.push_back(std::abs(pole) / two_pi);
    std::ranges::sort(hz);
    for (Index r = 0; r < count; ++r) {
      EXPECT_NEAR(hz[static_cast<std::size_t>(r)],
                  system.frequency_hz(r),
                  0.1 * separation * 50.0);
    }
  }
}

TEST(DoublePoles, OneModeIsNeverSplit) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937_64 random(seed);
    const double noise = 0.002 * seed;  // up to 20 %
    const modal::WeightedFrfs curves =
        curves_of(test::close_modes(1, 0.0, random), {0, 1, 2}, noise, random);
    EXPECT_EQ(found_under_one(curves).size(), 1) << seed;
  }
}

TEST(DoublePoles, NeedTwoReferences) {
  std::mt19937_64 random(3);
  const test::SyntheticSystem system = test::close_modes(2, 1e-3, random);
  EXPECT_EQ(found_under_one(curves_of(system, {0}, 0.0, random)).size(), 1);
}

/// How many of twenty systems come out with each mode in its place.
int right_of_twenty(Index count, Index references, double noise) {
  int right = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(700 + seed);
    const test::SyntheticSystem system = test::close_modes(count, 1e-3, random);
    std::vector<Index> sensors{0, 1, 2};
    sensors.resize(static_cast<std::size_t>(references));
    const modal::ModeSet set = modal::identify_modes(
        test::close_modes_frfs(system, sensors, noise, random), {});
    bool good = static_cast<Index>(set.modes.size()) == count;
    for (Index r = 0; good && r < count; ++r) {
      const modal::Mode& mode = set.modes[static_cast<std::size_t>(r)];
      const Eigen::VectorXcd phi =
          system.phi.col(r).cast<std::complex<double>>();
      // A quarter of the distance between them.
      good =
          std::abs(mode.frequency_hz / system.frequency_hz(r) - 1) < 2.5e-4 &&
          modal::mac(mode.shape, phi)(0, 0) > 0.9;
    }
    right += good ? 1 : 0;
  }
  return right;
}

TEST(DoublePoles, PairsATenthOfAPerCentApartNeedTwoReferences) {
  EXPECT_EQ(right_of_twenty(2, 2, 0.0), 20);
  EXPECT_GE(right_of_twenty(2, 2, 0.01), 19);
}

TEST(DoublePoles, TriplesATenthOfAPerCentApartNeedThreeReferences) {
  // Where the diagram already has two of the three, the third may stay hidden.
  EXPECT_GE(right_of_twenty(3, 3, 0.0), 18);
  EXPECT_GE(right_of_twenty(3, 3, 0.002), 18);
}

}  // namespace
}  // namespace tapfit
