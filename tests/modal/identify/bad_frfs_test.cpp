// FRFs that no structure has, or that something went wrong with: an error that
// says what, an empty result with its reason, or modes with finite numbers.
#include "acquisition/foundation/input_error.hpp"
#include "modal/identify/identify_modes.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"
#include "tests/support/matchers.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

namespace tapfit {
namespace {

using Eigen::Index;

/// Four modes at 20, 41, 63 and 88 Hz; six points, two sensors, 1 % noise.
signal::FrfSet four_modes() {
  std::mt19937_64 random(3);
  test::SyntheticSystem system;
  system.frequency_hz = Eigen::Vector4d(20.0, 41.0, 63.0, 88.0);
  system.damping_ratio = Eigen::Vector4d(0.005, 0.008, 0.006, 0.01);
  system.phi = test::random_shapes(6, 4, random);
  return test::roving_hammer(
      system, {0, 1}, test::line_points(5, 100, 380, 0.0), 0.01, random);
}

bool says(const modal::ModeSet& set, const std::string& words) {
  return std::ranges::any_of(set.warnings, [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

/// Identifies; every number that comes out is finite, and no modes have their
/// reason.
modal::ModeSet identified(const signal::FrfSet& frfs) {
  modal::ModeSet found = modal::identify_modes(frfs, {});
  EXPECT_TRUE(std::isfinite(found.synthesis_error));
  EXPECT_TRUE(std::isfinite(found.unrefined_error));
  for (const modal::Mode& mode : found.modes) {
    EXPECT_TRUE(std::isfinite(mode.frequency_sd_hz)) << mode.frequency_hz;
    EXPECT_TRUE(std::isfinite(mode.damping_sd)) << mode.frequency_hz;
    EXPECT_TRUE(mode.shape.allFinite()) << mode.frequency_hz;
    EXPECT_TRUE(mode.shape_sd.allFinite()) << mode.frequency_hz;
  }
  EXPECT_FALSE(found.modes.empty() && found.warnings.empty());
  return found;
}

void set_all(signal::FrfSet& set, const auto& value_at) {
  for (signal::Frf& frf : set.frfs) {
    for (Index k = 0; k < set.lines(); ++k) frf.H(k) = value_at(set.s(k));
  }
}

// Its row contradicts the others, so that the residues of a mode are of rank
// two, as those of two modes are.
TEST(BadFrfs, OneThatIsConstantMakesNoSecondModes) {
  signal::FrfSet set = four_modes();
  set.frfs[3].H.setConstant({2.0, 0.0});
  const modal::ModeSet found = identified(set);
  EXPECT_EQ(found.modes.size(), 4U);
  EXPECT_TRUE(says(found, "is constant"));
  for (const modal::Mode& mode : found.modes) {
    EXPECT_LT(mode.shape_sd.maxCoeff(), 0.1 * mode.shape.norm());
  }
}

TEST(BadFrfs, OneThatIsZeroIsLeftOut) {
  signal::FrfSet set = four_modes();
  set.frfs[3].H.setZero();
  const modal::ModeSet found = identified(set);
  EXPECT_EQ(found.modes.size(), 4U);
  EXPECT_TRUE(says(found, "is zero throughout"));
}

TEST(BadFrfs, NothingButZerosIsRefused) {
  signal::FrfSet set = four_modes();
  for (signal::Frf& frf : set.frfs) frf.H.setZero();
  EXPECT_THROW((void)modal::identify_modes(set, {}), InputError);
}

TEST(BadFrfs, ThoseGivenTwiceAreNoTwoModes) {
  signal::FrfSet set = four_modes();
  const std::vector<signal::Frf> once = set.frfs;
  const double sd = identified(set).modes[0].frequency_sd_hz;
  set.frfs.insert(set.frfs.end(), once.begin(), once.end());
  const modal::ModeSet twice = identified(set);
  EXPECT_EQ(twice.modes.size(), 4U);
  EXPECT_EQ(twice.modes[0].frequency_sd_hz, sd);
  EXPECT_TRUE(says(twice, "is there twice"));
  for (signal::Frf& frf : set.frfs) frf.H = once[0].H;
  EXPECT_EQ(identified(set).modes.size(), 4U);
  set.frfs.assign(5, once[0]);
  EXPECT_EQ(identified(set).modes.size(), 4U);
}

TEST(BadFrfs, LimitsOfDampingAreNamedWhereTheyLeaveNone) {
  modal::IdentifyOptions options;
  options.least_damping_ratio = 0.15;
  const modal::ModeSet found = modal::identify_modes(four_modes(), options);
  EXPECT_TRUE(found.modes.empty());
  EXPECT_TRUE(says(found, "damping from 15 to 20 %"));
}

TEST(BadFrfs, AMassLineHasNoModes) {
  signal::FrfSet set = four_modes();
  set_all(set, [](const std::complex<double>& s) { return s * s; });
  EXPECT_TRUE(identified(set).modes.empty());
}

TEST(BadFrfs, ADelayIsNotExplainedByModes) {
  signal::FrfSet set = four_modes();
  set_all(set,
          [](const std::complex<double>& s) { return std::exp(-0.3 * s); });
  const modal::ModeSet found = identified(set);
  EXPECT_TRUE(found.modes.empty() || says(found, "do not explain the FRFs"));
}

TEST(BadFrfs, MagnitudesAloneAreNotExplainedByModes) {
  signal::FrfSet set = four_modes();
  for (signal::Frf& frf : set.frfs) {
    frf.H = frf.H.cwiseAbs().cast<std::complex<double>>();
  }
  const modal::ModeSet found = identified(set);
  EXPECT_TRUE(found.modes.empty() || says(found, "do not explain the FRFs"));
}

// Products of such values are zero or infinite; identification would say that
// there are no modes.
TEST(BadFrfs, ValuesOfNoUnitAreRefused) {
  for (const double scale : {1e-200, 1e-100, 1e100, 1e200}) {
    signal::FrfSet set = four_modes();
    for (signal::Frf& frf : set.frfs) frf.H *= scale;
    EXPECT_THAT(
        [&] { (void)modal::identify_modes(set, {}); },
        Throws<InputError>(Property(&InputError::remedy, HasSubstr("unit"))))
        << scale;
  }
}

}  // namespace
}  // namespace tapfit
