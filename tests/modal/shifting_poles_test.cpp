// FRFs whose poles differ from one to the next without its being said.
#include "modal/identify_modes.hpp"
#include "tests/modal/loaded_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::modal {
namespace {

using Eigen::Index;

/// Four modes in the band and one above, hit at point 1; each FRF with a sensor
/// of so many kg at its response point only, all FRFs of one set-up.
signal::FrfSet one_reference(double kg, double noise) {
  constexpr Index points = 6;
  std::mt19937_64 random(3);
  test::SyntheticSystem system;
  system.frequency_hz.resize(5);
  system.frequency_hz << 15.0, 34.0, 58.0, 81.0, 130.0;
  system.damping_ratio = Eigen::VectorXd::Constant(5, 0.01);
  system.phi = test::random_shapes(points, 5, random);
  system.phi.row(0).setOnes();
  std::normal_distribution<double> normal;
  signal::FrfSet set;
  set.s = test::line_points(5, 100, 800, 0.0);
  for (Index point = 0; point < points; ++point) {
    signal::Frf frf;
    frf.channel = static_cast<std::size_t>(point) + 1;
    frf.response = {static_cast<int>(point) + 1, 3, 1};
    frf.reference = {1, 3, 1};
    frf.H.resize(set.lines());
    for (Index k = 0; k < set.lines(); ++k) {
      frf.H(k) =
          (1.0 + noise * normal(random)) *
          test::loaded_accelerance(system, {point}, kg, point, 0, set.s(k));
    }
    set.frfs.push_back(frf);
  }
  return set;
}

// Shifts of half of the half bandwidth: a second pole follows them, and is no
// mode.
TEST(ShiftingPoles, AreOneModeEachAndSaidToDiffer) {
  const ModeSet found = identify_modes(one_reference(2e-3, 0.001), {});
  EXPECT_EQ(found.modes.size(), 4U);
  EXPECT_TRUE(std::ranges::any_of(found.warnings, [](const std::string& said) {
    return said.find("not quite the same in all") != std::string::npos;
  }));
}

TEST(ShiftingPoles, AreRefinedToLessThanTheDiagramsPolesLeave) {
  for (const double kg : {1e-4, 4e-4, 1e-3, 3e-3}) {
    const ModeSet found = identify_modes(one_reference(kg, 0.003), {});
    EXPECT_LE(found.synthesis_error, found.unrefined_error) << kg;
  }
}

}  // namespace
}  // namespace tapfit::modal
