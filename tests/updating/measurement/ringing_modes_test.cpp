// Modes of a test whose hits come before the lowest mode has died out.
#include "updating/measurement/measurement.hpp"
#include "updating/measurement/undecayed_poles.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

// What rings of the hit before has the pole of the mode but not its place in
// s^2 R / (s - lambda): poles identified beside it are off or too badly
// known to be kept, and only by and by do they become good enough.
TEST(RingingModes, LowestModeIsWithinItsInterval) {
  VirtualBundleSpec spec = demo_spec();
  spec.effects = {};
  spec.points = 6;
  spec.hits = 3;
  spec.gap_s = 14.0;
  spec.damping_mean = 0.004;
  spec.faulty_hits = false;
  for (const std::uint64_t seed : {31, 33}) {
    spec.seed = seed;
    const fs::path folder =
        fs::path(testing::TempDir()) / "tapfit-ringing-modes";
    fs::remove_all(folder);
    const VirtualBundleResult truth = make_virtual_bundle(spec, folder);
    Measurement measurement(folder, acquisition::Unreadable::Refused);
    const modal::ModeSet& set = measurement.modes({});
    ASSERT_FALSE(set.modes.empty());
    const modal::Mode& mode = set.modes.front();
    // A third to two thirds of it are left when the next hit comes.
    EXPECT_GT(std::exp(mode.pole.real() * 14.0), 0.3);
    EXPECT_NEAR(mode.frequency_hz, truth.true_hz[0], 4.0 * mode.frequency_sd_hz)
        << seed;
    EXPECT_NEAR(
        mode.damping_ratio, truth.true_damping[0], 4.0 * mode.damping_sd)
        << seed;
  }
}

TEST(RingingModes, PolesRestWithinAHundredthOfTheirHalfBandwidth) {
  Eigen::VectorXcd poles(2);
  poles << std::complex<double>(-0.1, 26.0), std::complex<double>(-0.4, 80.0);
  EXPECT_TRUE(have_converged(poles, poles));
  EXPECT_TRUE(have_converged({}, {}));
  EXPECT_FALSE(have_converged({}, poles));
  Eigen::VectorXcd moved = poles;
  moved(0) += std::complex<double>(0.0, 0.0009);
  EXPECT_TRUE(have_converged(poles, moved));
  moved(0) += std::complex<double>(0.0, 0.0009);
  EXPECT_FALSE(have_converged(poles, moved));
}

}  // namespace
}  // namespace tapfit::updating
