#include "modal/identify/identify_modes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/mac.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"
#include "tests/support/matchers.hpp"

#include <cmath>
#include <limits>

namespace tapfit {
namespace {

using Eigen::Index;
using test::random_system;
using test::SyntheticSystem;

void expect_modes(const modal::ModeSet& found,
                  const SyntheticSystem& system,
                  Index in_band,
                  double frequency_tolerance,
                  double damping_tolerance) {
  ASSERT_EQ(found.modes.size(), static_cast<std::size_t>(in_band));
  for (Index r = 0; r < in_band; ++r) {
    const modal::Mode& mode = found.modes[static_cast<std::size_t>(r)];
    EXPECT_NEAR(
        mode.frequency_hz / system.frequency_hz(r), 1.0, frequency_tolerance);
    EXPECT_NEAR(
        mode.damping_ratio / system.damping_ratio(r), 1.0, damping_tolerance);
  }
}

TEST(IdentifyModes, FindsNoiseFreeModesWithScaledShapes) {
  for (const Index modes : {1, 2, 7, 15}) {
    std::mt19937_64 random(11 + static_cast<unsigned>(modes));
    const SyntheticSystem system = random_system(modes, 8, 0.002, 0.01, random);
    const signal::FrfSet frfs = test::roving_hammer(
        system, {0, 3}, test::line_points(5, 100, 900, 0.3), 0.0, random);
    const modal::ModeSet found = modal::identify_modes(frfs, {});
    SCOPED_TRACE(modes);
    // What is left is the two modes above the band, which the residual terms
    // can only approach.
    expect_modes(found, system, modes, 1e-4, 1e-3);
    ASSERT_TRUE(found.scaled);
    ASSERT_EQ(found.dofs.size(), 8U);
    EXPECT_LT(found.synthesis_error, 1e-3);
    for (std::size_t r = 0; r < found.modes.size(); ++r) {
      const Eigen::VectorXd phi = system.phi.col(static_cast<Index>(r));
      Eigen::VectorXcd shape = found.modes[r].shape;
      if ((shape.real().dot(phi)) < 0.0) shape = -shape;
      EXPECT_LT((shape - phi.cast<std::complex<double>>()).norm() / phi.norm(),
                2e-3);
      EXPECT_GT(found.modes[r].mpc, 0.999);
    }
  }
}

TEST(IdentifyModes, FindsHeavilyDampedModes) {
  std::mt19937_64 random(5);
  SyntheticSystem system = random_system(5, 10, 0.05, 0.05, random);
  const signal::FrfSet frfs = test::roving_hammer(
      system, {0, 3}, test::line_points(2, 105, 700, 0.0), 0.0, random);
  // Wide modes above the band reach far into it.
  expect_modes(modal::identify_modes(frfs, {}), system, 5, 1e-3, 1e-2);
}

TEST(IdentifyModes, StandsFivePercentNoise) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 random(seed);
    const SyntheticSystem system = random_system(6, 10, 0.003, 0.01, random);
    const signal::FrfSet frfs = test::roving_hammer(
        system, {0, 4}, test::line_points(5, 100, 900, 0.0), 0.05, random);
    SCOPED_TRACE(seed);
    expect_modes(modal::identify_modes(frfs, {}), system, 6, 1e-3, 5e-2);
  }
}

TEST(IdentifyModes, SeparatesCloseModesWithTwoReferences) {
  std::mt19937_64 random(3);
  SyntheticSystem system;
  system.frequency_hz.resize(4);
  system.frequency_hz << 150.0, 179.8, 180.8, 230.0;
  system.damping_ratio = Eigen::VectorXd::Constant(4, 0.005);
  system.phi = test::random_shapes(10, 4, random);
  const signal::FrfSet frfs = test::roving_hammer(
      system, {1, 6}, test::line_points(120, 260, 800, 0.4), 0.02, random);
  expect_modes(modal::identify_modes(frfs, {}), system, 4, 1e-3, 5e-2);
}

TEST(IdentifyModes, SeparatesAThousandthWithTwoReferences) {
  test::SyntheticSystem system;
  system.frequency_hz.resize(4);
  system.frequency_hz << 150.0, 180.0, 180.18, 230.0;
  system.damping_ratio = Eigen::VectorXd::Constant(4, 0.005);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(seed);
    system.phi = test::random_shapes(10, 4, random);
    const signal::FrfSet frfs = test::roving_hammer(
        system, {1, 6}, test::line_points(120, 260, 800, 0.0), 0.01, random);
    SCOPED_TRACE(seed);
    // A tenth of the 0.1 % between them.
    expect_modes(modal::identify_modes(frfs, {}), system, 4, 1e-4, 5e-2);
  }
}

TEST(IdentifyModes, FindsTenPercentDamping) {
  std::mt19937_64 random(5);
  SyntheticSystem system = random_system(4, 10, 0.10, 0.10, random);
  for (const double noise : {0.0, 0.02}) {
    const signal::FrfSet frfs = test::roving_hammer(
        system, {0, 3}, test::line_points(2, 105, 700, 0.0), noise, random);
    SCOPED_TRACE(noise);
    // Modes 20 % wide above the band are half of what is seen at its end.
    expect_modes(modal::identify_modes(frfs, {}), system, 4, 1e-2, 5e-2);
  }
}

TEST(IdentifyModes, FindsModesInOneFrf) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(3, 4, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {1}, test::line_points(5, 100, 400, 0.0), 0.001, random);
  frfs.frfs = {frfs.frfs[1]};  // the driving point
  const modal::ModeSet found = modal::identify_modes(frfs, {});
  expect_modes(found, system, 3, 1e-3, 2e-2);
  EXPECT_TRUE(found.scaled);
  EXPECT_EQ(found.dofs.size(), 1U);
}

TEST(IdentifyModes, TakesSigmaOutExactly) {
  std::mt19937_64 random(8);
  const SyntheticSystem system = random_system(4, 6, 0.004, 0.01, random);
  SyntheticSystem alone = system;
  alone.frequency_hz = system.frequency_hz.head(4).eval();
  alone.damping_ratio = system.damping_ratio.head(4).eval();
  alone.phi = system.phi.leftCols(4).eval();
  for (const double sigma : {0.0, 0.5, 3.0}) {
    const signal::FrfSet frfs = test::roving_hammer(
        alone, {0, 2}, test::line_points(5, 100, 900, sigma), 0.0, random);
    SCOPED_TRACE(sigma);
    // No mode out of the band: the modal model is exact.
    expect_modes(modal::identify_modes(frfs, {}), alone, 4, 1e-9, 1e-7);
  }
}

TEST(IdentifyModes, LosesNoneAndInventsNone) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "takes minutes under the thread sanitizer";
#endif
  int good = 0;
  std::string lost;
  std::uniform_real_distribution<double> uniform;
  constexpr int systems = 40;
  for (unsigned seed = 100; seed < 100 + systems; ++seed) {
    std::mt19937_64 random(seed);
    const Index modes = 2 + static_cast<Index>(seed % 11);
    const SyntheticSystem system = random_system(modes, 8, 0.002, 0.01, random);
    const double noise = 0.03 * uniform(random);
    const signal::FrfSet frfs = test::roving_hammer(
        system, {0, 5}, test::line_points(5, 100, 600, 0.5), noise, random);
    const modal::ModeSet found = modal::identify_modes(frfs, {});
    bool all = found.modes.size() == static_cast<std::size_t>(modes);
    for (std::size_t r = 0; all && r < found.modes.size(); ++r) {
      all = std::abs(found.modes[r].frequency_hz /
                         system.frequency_hz(static_cast<Index>(r)) -
                     1.0) < 2e-3;
    }
    if (all) ++good;
    if (!all) lost += std::to_string(seed) + " ";
  }
  EXPECT_GE(good, 38) << "wrong with seeds " << lost;  // 95 %
}

TEST(IdentifyModes, WorksWithOneReferenceAndNoVariance) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(3, 4, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {1}, test::line_points(5, 100, 300, 0.2), 0.03, random);
  for (signal::Frf& frf : frfs.frfs) {
    frf.variance.setZero();
    frf.hits = 1;
  }
  expect_modes(modal::identify_modes(frfs, {}), system, 3, 2e-3, 0.1);
}

TEST(IdentifyModes, WorksWithAMissingFrf) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(5, 8, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {1, 4}, test::line_points(5, 100, 600, 0.2), 0.01, random);
  frfs.frfs.erase(frfs.frfs.begin() + 5);
  const modal::ModeSet found = modal::identify_modes(frfs, {});
  expect_modes(found, system, 5, 1e-3, 0.05);
  EXPECT_EQ(found.dofs.size(), 8U);
}

TEST(IdentifyModes, TurnsSignsToPlus) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(3, 5, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {0, 1}, test::line_points(5, 100, 600, 0.2), 0.0, random);
  for (signal::Frf& frf : frfs.frfs) {
    if (frf.reference.node != 3) continue;
    frf.reference.sign = -1;
    frf.H = -frf.H;
  }
  const modal::ModeSet found = modal::identify_modes(frfs, {});
  ASSERT_EQ(found.modes.size(), 3U);
  for (std::size_t r = 0; r < 3; ++r) {
    const Eigen::VectorXcd phi =
        system.phi.col(static_cast<Index>(r)).cast<std::complex<double>>();
    EXPECT_GT(modal::mac(found.modes[r].shape, phi)(0, 0), 0.9999);
  }
}

TEST(IdentifyModes, WithoutDrivingPointKeepsTheHitPoints) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(3, 6, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {0, 1}, test::line_points(5, 100, 600, 0.2), 0.0, random);
  std::erase_if(frfs.frfs,
                [](const signal::Frf& frf) { return frf.reference.node <= 2; });
  const modal::ModeSet found = modal::identify_modes(frfs, {});
  EXPECT_FALSE(found.scaled);
  ASSERT_EQ(found.dofs.size(), 4U);
  EXPECT_EQ(found.dofs.front().node, 3);
  EXPECT_FALSE(found.warnings.empty());
  ASSERT_EQ(found.modes.size(), 3U);
  const Eigen::VectorXcd phi =
      system.phi.col(1).tail(4).cast<std::complex<double>>();
  EXPECT_GT(modal::mac(found.modes[1].shape, phi)(0, 0), 0.9999);
}

// A sensor's mass m moves mode r by about -m phi^2 / 2 of its frequency; here
// each run has its own modes, within 2 % of the first's.
struct RovingSensors {
  SyntheticSystem still;
  signal::FrfSet frfs;
};

RovingSensors sensors_that_move_the_modes() {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform;
  RovingSensors test{random_system(4, 10, 0.004, 0.006, random), {}};
  test.still.phi.row(0).setOnes();  // the hammer is in no mode's node
  SyntheticSystem system = test.still;
  test.frfs.s = test::line_points(5, 100, 900, 0.3);
  for (int run = 0; run < 4; ++run) {
    for (Index r = 0; r < 4; ++r) {
      system.frequency_hz(r) =
          test.still.frequency_hz(r) * (1.0 - 0.02 * uniform(random));
    }
    const signal::FrfSet all = test::roving_hammer(
        system, {2 * run + 2, 2 * run + 3}, test.frfs.s, 0.005, random);
    for (signal::Frf frf : all.frfs) {
      if (frf.reference.node != 1) continue;
      frf.run = static_cast<std::size_t>(run);
      test.frfs.frfs.push_back(frf);
    }
  }
  return test;
}

TEST(IdentifyModes, FitsEachRunWhereSensorsMoveTheModes) {
  const auto [system, frfs] = sensors_that_move_the_modes();
  const Eigen::VectorXd& still = system.frequency_hz;
  const modal::ModeSet found = modal::identify_modes(frfs, {});
  ASSERT_EQ(found.modes.size(), 4U);
  ASSERT_EQ(found.dofs.size(), 8U);
  // Each set-up's poles are refined, too.
  EXPECT_LT(found.synthesis_error, 0.9 * found.unrefined_error);
  for (std::size_t r = 0; r < 4; ++r) {
    const modal::Mode& mode = found.modes[r];
    const Eigen::VectorXcd phi = system.phi.col(static_cast<Index>(r))
                                     .tail(8)
                                     .cast<std::complex<double>>();
    EXPECT_NEAR(mode.frequency_hz / still(static_cast<Index>(r)), 0.99, 0.01);
    EXPECT_GT(mode.frequency_sd_hz / mode.frequency_hz, 1e-3);
    EXPECT_GT(modal::mac(mode.shape, phi)(0, 0), 0.99);
  }
}

// The frequency by which a mode is known is the mean: no run need have it.
TEST(IdentifyModes, DropsAndPutsBackWhatEachRunHasElsewhere) {
  using What = modal::PoleEdit::What;
  const auto [system, frfs] = sensors_that_move_the_modes();
  const modal::ModeSet all = modal::identify_modes(frfs, {});
  ASSERT_EQ(all.modes.size(), 4U);
  const double hz = all.modes[2].frequency_hz;
  modal::IdentifyOptions options;
  options.edits = {{What::Drop, hz}};
  const modal::ModeSet fewer = modal::identify_modes(frfs, options);
  ASSERT_EQ(fewer.modes.size(), 3U);
  EXPECT_NEAR(fewer.modes[1].frequency_hz, all.modes[1].frequency_hz, 0.1);
  EXPECT_NEAR(fewer.modes[2].frequency_hz, all.modes[3].frequency_hz, 0.1);
  options.edits.push_back({What::Add, hz});
  const modal::ModeSet again = modal::identify_modes(frfs, options);
  ASSERT_EQ(again.modes.size(), 4U);
  EXPECT_NEAR(again.modes[2].frequency_hz, hz, 0.01);
  EXPECT_NEAR(
      again.modes[2].frequency_sd_hz, all.modes[2].frequency_sd_hz, 0.01);
  options.edits = {{What::Drop, 1.1 * all.modes[3].frequency_hz}};
  EXPECT_THROW((void)modal::identify_modes(frfs, options), InputError);
}

TEST(IdentifyModes, RefusesTooFewLines) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(2, 3, 0.005, 0.01, random);
  const signal::FrfSet frfs = test::roving_hammer(
      system, {0}, test::line_points(5, 100, 5, 0.2), 0.0, random);
  EXPECT_THROW((void)modal::identify_modes(frfs, {}), InputError);
}

TEST(IdentifyModes, RefusesWhatIsNotFinite) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(2, 3, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {0}, test::line_points(5, 100, 50, 0.2), 0.0, random);
  frfs.frfs[1].H(7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)modal::identify_modes(frfs, {}), InputError);
}

TEST(IdentifyModes, NamesTheLineThatIsMissing) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(3, 4, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {1}, test::line_points(10, 59, 50, 0.0), 0.0, random);
  const auto without = [](const Eigen::VectorXcd& x) {
    Eigen::VectorXcd rest(x.size() - 1);
    rest << x.head(20), x.tail(x.size() - 21);
    return rest;
  };
  frfs.s = without(frfs.s);
  for (signal::Frf& frf : frfs.frfs) frf.H = without(frf.H);
  EXPECT_THAT(
      [&] { (void)modal::identify_modes(frfs, {}); },
      Throws<InputError>(Property(&InputError::where,
                                  HasSubstr("29 Hz is followed by 31 Hz"))));
}

TEST(IdentifyModes, RefusesUnevenLines) {
  std::mt19937_64 random(4);
  const SyntheticSystem system = random_system(2, 3, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {0}, test::line_points(5, 100, 50, 0.2), 0.0, random);
  frfs.s(7) += std::complex<double>(0.0, 3.0);
  EXPECT_THROW((void)modal::identify_modes(frfs, {}), InputError);
}

TEST(IdentifyModes, FindsNothingInConstantFrfsOrNoise) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const SyntheticSystem system = random_system(2, 5, 0.005, 0.01, random);
  signal::FrfSet frfs = test::roving_hammer(
      system, {0, 1}, test::line_points(5, 100, 300, 0.2), 0.0, random);
  for (signal::Frf& frf : frfs.frfs) frf.H.setConstant({2.0, 0.0});
  const modal::ModeSet constant = modal::identify_modes(frfs, {});
  EXPECT_TRUE(constant.modes.empty());
  EXPECT_FALSE(constant.warnings.empty());
  for (signal::Frf& frf : frfs.frfs) {
    for (std::complex<double>& value : frf.H) {
      value = {normal(random), normal(random)};
    }
    frf.variance.setConstant(2.0);
  }
  EXPECT_TRUE(modal::identify_modes(frfs, {}).modes.empty());
}

}  // namespace
}  // namespace tapfit
