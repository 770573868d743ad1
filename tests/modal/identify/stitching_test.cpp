// Set-ups that share no complete row or column, put together by reciprocity.
#include "modal/identify/identify_modes.hpp"
#include "modal/mode_set/mac.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"
#include "tests/support/matchers.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit {
namespace {

using Eigen::Index;

/// Three modes, shapes of unit modal mass at twelve points.
test::SyntheticSystem twelve_points() {
  std::mt19937_64 random(31);
  test::SyntheticSystem system;
  system.frequency_hz.resize(3);
  system.frequency_hz << 21.0, 47.0, 78.0;
  system.damping_ratio = Eigen::VectorXd::Constant(3, 0.006);
  system.phi = test::random_shapes(12, 3, random);
  return system;
}

struct Pair {
  int sensor = 0;
  int hit = 0;
  std::size_t run = 0;
};

signal::FrfSet measured(const test::SyntheticSystem& system,
                        const std::vector<Pair>& pairs,
                        double noise) {
  std::mt19937_64 random(32);
  std::normal_distribution<double> normal;
  signal::FrfSet set;
  set.s = test::line_points(5, 100, 500, 0.1);
  for (const Pair& pair : pairs) {
    signal::Frf frf;
    frf.response = {pair.sensor, 3, 1};
    frf.reference = {pair.hit, 3, 1};
    frf.run = pair.run;
    frf.hits = 3;
    frf.H.resize(set.lines());
    for (Index k = 0; k < set.lines(); ++k) {
      frf.H(k) =
          test::accelerance(system, pair.sensor - 1, pair.hit - 1, set.s(k));
    }
    const double sd =
        noise * frf.H.norm() / std::sqrt(static_cast<double>(set.lines()));
    for (Index k = 0; k < set.lines(); ++k) {
      frf.H(k) += sd / std::sqrt(2.0) *
                  std::complex<double>(normal(random), normal(random));
    }
    frf.variance = Eigen::VectorXd::Constant(set.lines(), sd * sd);
    frf.coherence = Eigen::VectorXd::Ones(set.lines());
    set.frfs.push_back(std::move(frf));
  }
  return set;
}

/// Roving hammer over points 1 to 6 with sensors at 1 and 2, then a roving
/// sensor over 7 to 12 with the hammer at 2.
std::vector<Pair> both_ways() {
  std::vector<Pair> pairs;
  std::size_t run = 0;
  for (int hit = 1; hit <= 6; ++hit, ++run) {
    pairs.push_back({1, hit, run});
    pairs.push_back({2, hit, run});
  }
  for (int sensor = 7; sensor <= 12; ++sensor, ++run) {
    pairs.push_back({sensor, 2, run});
  }
  return pairs;
}

void expect_shapes(const modal::ModeSet& found,
                   const test::SyntheticSystem& system,
                   double tolerance) {
  ASSERT_EQ(found.modes.size(), 3U);
  ASSERT_EQ(found.dofs.size(), 12U);
  for (std::size_t r = 0; r < 3; ++r) {
    Eigen::VectorXd truth = system.phi.col(static_cast<Index>(r));
    Eigen::Index largest = 0;
    truth.cwiseAbs().maxCoeff(&largest);
    if (truth(largest) < 0.0) truth = -truth;
    // The scale too, not the MAC alone.
    EXPECT_LT(
        (found.modes[r].shape - truth.cast<std::complex<double>>()).norm(),
        tolerance * truth.norm())
        << r;
  }
}

TEST(Stitching, RovingHammerAndRovingSensorGiveOneShapeOfUnitModalMass) {
  const test::SyntheticSystem system = twelve_points();
  const modal::ModeSet clean =
      modal::identify_modes(measured(system, both_ways(), 0.0), {});
  EXPECT_TRUE(clean.scaled);
  expect_shapes(clean, system, 1e-4);
  // 2 % on each line; some 5 lines within a bandwidth.
  expect_shapes(modal::identify_modes(measured(system, both_ways(), 0.02), {}),
                system,
                0.03);
}

// Three points measured against each other give the scale without any driving
// point: phi_1^2 = P_12 P_13 / P_23.
TEST(Stitching, ThreePointsAgainstEachOtherReplaceTheDrivingPoint) {
  const test::SyntheticSystem system = twelve_points();
  std::vector<Pair> pairs = both_ways();
  std::erase_if(pairs, [](const Pair& p) { return p.sensor == p.hit; });
  const modal::ModeSet found =
      modal::identify_modes(measured(system, pairs, 0.0), {});
  // 1 / 3, 2 / 3 and 1 / 2 close the ring.
  EXPECT_TRUE(found.scaled);
  expect_shapes(found, system, 1e-4);
}

TEST(Stitching, SaysWhatCannotBeScaledOrReached) {
  const test::SyntheticSystem system = twelve_points();
  // Neither a driving point nor a ring: sensor 1 alone, hammer not at it.
  std::vector<Pair> pairs = both_ways();
  std::erase_if(pairs,
                [](const Pair& p) { return p.sensor != 1 || p.hit == 1; });
  const modal::ModeSet unscaled =
      modal::identify_modes(measured(system, pairs, 0.0), {});
  EXPECT_FALSE(unscaled.scaled);
  ASSERT_FALSE(unscaled.warnings.empty());
  EXPECT_THAT(unscaled.warnings.front(), HasSubstr("no driving-point FRF"));
  // A set-up that shares no point with the others.
  pairs = both_ways();
  std::erase_if(pairs,
                [](const Pair& p) { return p.hit == 2 && p.sensor > 6; });
  pairs.push_back({11, 12, 20});
  const modal::ModeSet apart =
      modal::identify_modes(measured(system, pairs, 0.0), {});
  EXPECT_EQ(apart.dofs.size(), 6U);
  const auto said = std::ranges::any_of(apart.warnings, [](const auto& text) {
    return text.find("2 points share no hammer or sensor") != std::string::npos;
  });
  EXPECT_TRUE(said);
  pairs.pop_back();
  pairs.push_back({11, 11, 20});
  const modal::ModeSet alone =
      modal::identify_modes(measured(system, pairs, 0.0), {});
  EXPECT_THAT(alone.warnings,
              testing::Contains(HasSubstr("1 point shares no hammer or sensor "
                                          "with the others and is left out")));
}

}  // namespace
}  // namespace tapfit
