// Identification steered by hand: band, poles dropped and added, hard checks.
#include "acquisition/foundation/input_error.hpp"
#include "modal/identify/identify_modes.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"
#include "tests/support/matchers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tapfit {
namespace {

using What = modal::PoleEdit::What;

signal::FrfSet four_modes(double noise = 0.02, unsigned seed = 12) {
  std::mt19937_64 random(seed);
  test::SyntheticSystem system;
  system.frequency_hz.resize(4);
  system.frequency_hz << 20.0, 41.0, 63.0, 82.0;
  system.damping_ratio = Eigen::VectorXd::Constant(4, 0.008);
  system.phi = test::random_shapes(6, 4, random);
  return test::roving_hammer(
      system, {0, 2}, test::line_points(5, 100, 500, 0.1), noise, random);
}

TEST(EditModes, DropsAndPutsBackByFrequency) {
  const signal::FrfSet frfs = four_modes();
  modal::IdentifyOptions options;
  const modal::ModeSet all = modal::identify_modes(frfs, options);
  ASSERT_EQ(all.modes.size(), 4U);
  options.edits = {{What::Drop, 41.2}};
  const modal::ModeSet fewer = modal::identify_modes(frfs, options);
  ASSERT_EQ(fewer.modes.size(), 3U);
  EXPECT_NEAR(fewer.modes[1].frequency_hz, 63.0, 0.1);
  EXPECT_GT(fewer.synthesis_error, 2.0 * all.synthesis_error);
  options.edits.push_back({What::Add, 40.9});
  const modal::ModeSet again = modal::identify_modes(frfs, options);
  ASSERT_EQ(again.modes.size(), 4U);
  // The same least squares from another start.
  EXPECT_NEAR(again.modes[1].frequency_hz, all.modes[1].frequency_hz, 1e-4);
  EXPECT_NEAR(again.modes[1].damping_ratio, all.modes[1].damping_ratio, 1e-5);
}

TEST(EditModes, AreDoneInTheirOrder) {
  const signal::FrfSet frfs = four_modes();
  modal::IdentifyOptions options;
  options.max_damping_ratio = 0.004;  // all modes have 0.008: none is found
  // What was put in by hand can be taken out again.
  options.edits = {{What::Add, 41.0}, {What::Add, 63.0}, {What::Drop, 41.0}};
  const modal::ModeSet found = modal::identify_modes(frfs, options);
  ASSERT_EQ(found.modes.size(), 1U);
  EXPECT_NEAR(found.modes[0].frequency_hz, 63.0, 0.1);
}

TEST(EditModes, SaysWhereThereIsNothingToDropOrAdd) {
  const signal::FrfSet frfs = four_modes();
  modal::IdentifyOptions options;
  options.edits = {{What::Drop, 50.0}};
  EXPECT_THAT(
      [&] { (void)modal::identify_modes(frfs, options); },
      Throws<InputError>(Property(&InputError::remedy, HasSubstr("41"))));
  options.edits = {{What::Add, 41.0}};  // a mode is there, and no noise to fit
  EXPECT_THROW((void)modal::identify_modes(four_modes(0.0), options),
               InputError);
  for (const double beside : {101.0, 400.0, 1e300}) {
    options.edits = {{What::Add, beside}};
    EXPECT_THAT([&] { (void)modal::identify_modes(frfs, options); },
                Throws<InputError>(Property(&InputError::remedy,
                                            "the lines go from 5 to 100 Hz")))
        << beside;
  }
}

TEST(EditModes, LooksAtTheBandAskedForOnly) {
  const signal::FrfSet frfs = four_modes();
  modal::IdentifyOptions options;
  options.band_hz = {30.0, 72.0};
  const modal::ModeSet found = modal::identify_modes(frfs, options);
  ASSERT_EQ(found.modes.size(), 2U);
  EXPECT_NEAR(found.modes[0].frequency_hz, 41.0, 0.02);
  EXPECT_NEAR(found.modes[1].frequency_hz, 63.0, 0.03);
  // The fit stands on the band's lines and nowhere else.
  const Eigen::VectorXd f = frfs.frequency_hz();
  ASSERT_EQ(found.fitted.size(), frfs.frfs.size());
  for (Eigen::Index k = 0; k < f.size(); ++k) {
    const bool inside = f(k) >= 30.0 && f(k) <= 72.0;
    EXPECT_EQ(std::abs(found.fitted[1](k)) > 0.0, inside) << f(k);
  }
}

TEST(EditModes, ABandWithoutModesIsEmptyWithItsReason) {
  modal::IdentifyOptions options;
  options.band_hz = {48.0, 55.0};
  const modal::ModeSet found = modal::identify_modes(four_modes(), options);
  EXPECT_TRUE(found.modes.empty());
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_THAT(found.warnings.back(), HasSubstr("no mode found"));
}

TEST(EditModes, ABandBesideTheFrfsIsRefusedWithTheirRange) {
  modal::IdentifyOptions options;
  options.band_hz = {400.0, 500.0};
  EXPECT_THAT([&] { (void)modal::identify_modes(four_modes(), options); },
              Throws<InputError>(AllOf(
                  Property(&InputError::where, "band"),
                  Property(&InputError::remedy, HasSubstr("5 to 100 Hz")))));
}

TEST(EditModes, HardChecksAreThoseOfTheOptions) {
  const signal::FrfSet frfs = four_modes();
  modal::IdentifyOptions options;
  options.max_damping_ratio = 0.004;  // all modes have 0.008
  EXPECT_TRUE(modal::identify_modes(frfs, options).modes.empty());
  options = {};
  options.least_mpc = 1.1;  // no shape has that
  const modal::ModeSet none = modal::identify_modes(frfs, options);
  EXPECT_TRUE(none.modes.empty());
  EXPECT_THAT(none.warnings.front(), HasSubstr("do not move in phase"));
}

TEST(EditModes, LeastMpcIsThatOfTheShapesGiven) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const signal::FrfSet frfs = four_modes(0.2, seed);
    modal::IdentifyOptions options;
    const modal::ModeSet all = modal::identify_modes(frfs, options);
    std::vector<double> mpc;
    for (const modal::Mode& mode : all.modes) mpc.push_back(mode.mpc);
    ASSERT_GT(mpc.size(), 2U);
    std::ranges::sort(mpc);
    options.least_mpc = 0.5 * (mpc[0] + mpc[1]);
    const modal::ModeSet fewer = modal::identify_modes(frfs, options);
    EXPECT_EQ(fewer.modes.size() + 1, all.modes.size()) << seed;
    for (const modal::Mode& mode : fewer.modes) {
      EXPECT_GE(mode.mpc, options.least_mpc) << seed;
    }
  }
}

TEST(EditModes, APoleBesideAModeIsRefusedOrSaidToBeUnresolved) {
  int told = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const signal::FrfSet frfs = four_modes(seed % 2 == 0 ? 0.0 : 0.2, seed);
    modal::IdentifyOptions options;
    options.edits = {{What::Add, 41.0}};
    try {
      const modal::ModeSet set = modal::identify_modes(frfs, options);
      EXPECT_TRUE(std::ranges::any_of(set.warnings, [](const auto& warning) {
        return warning.find("is not resolved") != std::string::npos;
      })) << seed;
    } catch (const InputError& error) {
      const std::string what = error.what();
      told += what.find("cannot be told") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GT(told, 0) << "the others run away";
}

TEST(EditModes, RefinementLowersTheErrorAndClustersHaveTheirScatter) {
  const modal::ModeSet found = modal::identify_modes(four_modes(0.0), {});
  ASSERT_EQ(found.modes.size(), 4U);
  EXPECT_LT(found.synthesis_error, 0.5 * found.unrefined_error);
  for (const modal::Mode& mode : found.modes) {
    EXPECT_GT(mode.cluster.poles, 10);
    EXPECT_NEAR(mode.cluster.frequency_hz, mode.frequency_hz, 0.05);
    EXPECT_GT(mode.cluster.frequency_scatter_hz, 0.0);
    EXPECT_LT(mode.cluster.frequency_scatter_hz, 0.1);
    EXPECT_NEAR(mode.cluster.damping_ratio, mode.damping_ratio, 1e-3);
  }
}

}  // namespace
}  // namespace tapfit
