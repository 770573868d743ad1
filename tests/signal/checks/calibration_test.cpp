#include "signal/checks/calibration.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::signal {
namespace {

FrfSet mass_line(
    double mass, double gain, double delay, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, std::sqrt(0.5));
  FrfSet set;
  set.s.resize(300);
  set.s.real().setConstant(2.0);
  set.s.imag().setLinSpaced(2.0 * std::numbers::pi * 50.0,
                            2.0 * std::numbers::pi * 2000.0);
  Frf frf;
  frf.response = {1, 3, -1};
  frf.reference = {1, 3, 1};
  frf.H.resize(set.s.size());
  for (Eigen::Index i = 0; i < set.s.size(); ++i) {
    const std::complex<double> error(normal(random), normal(random));
    frf.H(i) =
        -gain / mass * std::exp(-set.s(i) * delay) * (1.0 + noise * error);
  }
  frf.variance = noise * noise * frf.H.cwiseAbs2();
  set.frfs.push_back(frf);
  return set;
}

TEST(Calibration, FindsGainAndDelay) {
  const Calibration c = calibrate(mass_line(2.5, 1.03, 2e-4, 0.0, 1), 2.5)[0];
  EXPECT_NEAR(c.gain, 1.03, 1e-12);
  EXPECT_NEAR(c.delay_s, 2e-4, 1e-15);
  EXPECT_LT(c.deviation, 1e-12);
}

TEST(Calibration, ATurnedPolarityIsAGainBelowZero) {
  // With a delay that turns the phase several times over the band.
  const Calibration c = calibrate(mass_line(2.5, -0.97, 1e-3, 0.0, 1), 2.5)[0];
  EXPECT_NEAR(c.gain, -0.97, 1e-12);
  EXPECT_NEAR(c.delay_s, 1e-3, 1e-14);
}

TEST(Calibration, ItsStandardDeviationsHold) {
  int gain_inside = 0;
  int delay_inside = 0;
  constexpr int repeats = 400;
  for (unsigned seed = 1; seed <= repeats; ++seed) {
    const Calibration c =
        calibrate(mass_line(1.25, 1.0, 1e-5, 0.02, seed), 1.25)[0];
    gain_inside += std::abs(c.gain - 1.0) < 1.96 * c.gain_sd ? 1 : 0;
    delay_inside += std::abs(c.delay_s - 1e-5) < 1.96 * c.delay_sd ? 1 : 0;
  }
  // 95 % of 400, four standard deviations of a binomial number.
  EXPECT_NEAR(gain_inside, 380, 18);
  EXPECT_NEAR(delay_inside, 380, 18);
}

TEST(Calibration, RefusesNoMass) {
  EXPECT_THROW((void)calibrate(mass_line(1.0, 1.0, 0.0, 0.0, 1), 0.0),
               InputError);
}

}  // namespace
}  // namespace tapfit::signal
