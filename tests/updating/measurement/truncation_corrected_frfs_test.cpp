// FRFs of modes that outlast the block, their poles identified on the way.
#include "updating/measurement/truncation_corrected_frfs.hpp"

#include "tests/signal/support/scale_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

namespace tapfit::updating {
namespace {

using signal::GeneratedOptions;
using signal::GeneratedTest;
using signal::TestMode;

// Both modes with `time_constants` of them in the block.
std::vector<TestMode> modes_with(double time_constants,
                                 const GeneratedOptions& o) {
  const double T = static_cast<double>(o.block - o.pre_trigger) / o.fs;
  std::vector<TestMode> modes{{20.0, 0.0, 1.0}, {61.0, 0.0, -0.7}};
  for (TestMode& mode : modes) {
    mode.zeta = time_constants / (2.0 * std::numbers::pi * mode.hz * T);
  }
  return modes;
}

TEST(TruncationCorrectedFrfs, AreRightWithoutAWindowFromASingleHit) {
  GeneratedOptions o;
  for (const double time_constants : {6.0, 3.0}) {
    const auto modes = modes_with(time_constants, o);
    GeneratedTest test = signal::generate_test(modes, o);
    test.bundle.band_hz = {5.0, 100.0};
    const TruncationCorrectedFrfs found = estimate_truncation_corrected_frfs(
        test.bundle, test.recordings, test.hits, {});
    ASSERT_EQ(found.poles.size(), 2);
    signal::FrfOptions options;
    options.window.end_value = 1.0;
    const double cut = worst_of(test, modes, options).scale;
    options.lasting_poles = found.poles;
    EXPECT_LT(worst_of(test, modes, options).scale, 0.05 * cut)
        << time_constants;
  }
}

TEST(TruncationCorrectedFrfs, SayWhatWasDone) {
  GeneratedOptions o;
  const auto modes = modes_with(3.0, o);
  GeneratedTest test = signal::generate_test(modes, o);
  const auto said = [&] {
    const auto set = estimate_truncation_corrected_frfs(
                         test.bundle, test.recordings, test.hits, {})
                         .set;
    return std::ranges::count_if(set.statements, [](const std::string& words) {
      return words.starts_with("2 modes (") &&
             words.find("have not decayed") != std::string::npos;
    });
  };
  test.bundle.band_hz = {5.0, 100.0};
  EXPECT_EQ(said(), 1);
  test.bundle.band_hz = {40.0, 50.0};
  EXPECT_EQ(said(), 0);
}

// A test that names no band is followed as far as its hits excite.
TEST(TruncationCorrectedFrfs, AreFollowedWithoutABandUpToWhereHitsReach) {
  GeneratedOptions o;
  const auto modes = modes_with(3.0, o);
  GeneratedTest test = signal::generate_test(modes, o);
  ASSERT_FALSE(test.bundle.band_hz);
  test.hits.usable_bandwidth_hz = 100.0;
  TruncationCorrectedFrfs found = estimate_truncation_corrected_frfs(
      test.bundle, test.recordings, test.hits, {});
  EXPECT_EQ(found.poles.size(), 2);
  EXPECT_FALSE(found.modes) << "they are not of all lines";
  test.hits.usable_bandwidth_hz = 45.0;
  found = estimate_truncation_corrected_frfs(
      test.bundle, test.recordings, test.hits, {});
  ASSERT_EQ(found.poles.size(), 1);
  EXPECT_NEAR(found.poles(0).imag(), 2.0 * std::numbers::pi * 20.0, 0.1);
}

TEST(TruncationCorrectedFrfs, AreThereWhereTooFewLinesTellModes) {
  GeneratedOptions o;
  GeneratedTest test = signal::generate_test(modes_with(3.0, o), o);
  test.bundle.band_hz = {19.9, 20.3};
  const TruncationCorrectedFrfs found = estimate_truncation_corrected_frfs(
      test.bundle, test.recordings, test.hits, {});
  EXPECT_LT(found.set.lines(), 8);
  EXPECT_FALSE(found.modes);
  EXPECT_EQ(found.poles.size(), 0);
}

}  // namespace
}  // namespace tapfit::updating
