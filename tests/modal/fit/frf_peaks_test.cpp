// Peaks against systems whose poles are known in closed form.
#include "modal/fit/frf_peaks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

struct System {
  Eigen::VectorXcd s;
  Eigen::VectorXcd H;
};

Complex pole_of(double hz, double zeta) {
  const double w = 2.0 * pi * hz;
  return {-zeta * w, w * std::sqrt(1.0 - zeta * zeta)};
}

/// Accelerance of two oscillators with unit modal mass on s = sigma + j omega.
System two_oscillators(double sigma) {
  constexpr Eigen::Index lines = 600;
  System system{Eigen::VectorXcd(lines), Eigen::VectorXcd(lines)};
  for (Eigen::Index i = 0; i < lines; ++i) {
    const Complex s{sigma, 2.0 * pi * (5.0 + 0.05 * static_cast<double>(i))};
    system.s[i] = s;
    system.H[i] = 0.0;
    for (const Complex& p : {pole_of(12.0, 0.01), pole_of(27.0, 0.008)}) {
      system.H[i] += s * s / ((s - p) * (s - std::conj(p)));
    }
  }
  return system;
}

TEST(FrfPeaks, AreWhereTheResonancesAre) {
  const System system = two_oscillators(0.0);
  const auto found = peak_lines(system.H.cwiseAbs());
  ASSERT_EQ(found.size(), 2U);
  // The peak of an accelerance lies zeta^2 above the resonance: below a line.
  EXPECT_NEAR(system.s[found[0]].imag() / (2.0 * pi), 12.0, 0.05);
  EXPECT_NEAR(system.s[found[1]].imag() / (2.0 * pi), 27.0, 0.05);
}

TEST(FrfPeaks, LeaveRipplesOut) {
  Eigen::VectorXd size(9);
  size << 1, 5, 1, 1.4, 1.2, 8, 6, 7, 1;
  EXPECT_EQ(peak_lines(size), (std::vector<Eigen::Index>{1, 5}));
  EXPECT_EQ(peak_lines(size, 1.01), (std::vector<Eigen::Index>{1, 3, 5, 7}));
  EXPECT_TRUE(peak_lines(Eigen::VectorXd::Ones(5)).empty());
  EXPECT_TRUE(peak_lines(Eigen::VectorXd()).empty());
}

/// With circular noise of that deviation per line, as many hits would leave.
signal::Frf noisy(const Eigen::VectorXcd& H,
                  double sd,
                  double freedom,
                  unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> part(0.0, sd / std::sqrt(2.0));
  std::chi_squared_distribution<double> spread(freedom);
  signal::Frf frf;
  frf.H = H;
  frf.variance.resize(H.size());
  frf.variance_freedom = freedom;
  for (Eigen::Index i = 0; i < H.size(); ++i) {
    frf.H[i] += Complex(part(random), part(random));
    frf.variance[i] = sd * sd * spread(random) / freedom;
  }
  return frf;
}

// In 95 of 100 there is no peak that is none, by what the circles promise.
TEST(FrfPeaks, OfNoiseAloneThereAreNone) {
  int any = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const signal::Frf frf =
        noisy(Eigen::VectorXcd::Constant(600, 1.0), 0.5, 24.0, seed);
    EXPECT_FALSE(peak_lines(frf.H.cwiseAbs()).empty());
    any += peak_lines(frf).empty() ? 0 : 1;
  }
  EXPECT_LE(any, 5);
}

// Between the resonances |H| falls to 1, where the noise is as large.
TEST(FrfPeaks, OfANoisyFrfAreItsResonances) {
  const System system = two_oscillators(0.0);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const signal::Frf frf = noisy(system.H, 1.0, 24.0, seed);
    EXPECT_GT(peak_lines(frf.H.cwiseAbs()).size(), 10U);
    const auto found = peak_lines(frf);
    ASSERT_EQ(found.size(), 2U) << seed;
    // Its top is flat: a few lines wide at a damping of 1 %.
    EXPECT_NEAR(system.s[found[0]].imag() / (2.0 * pi), 12.0, 0.15);
    EXPECT_NEAR(system.s[found[1]].imag() / (2.0 * pi), 27.0, 0.25);
  }
}

TEST(FrfPeaks, AreAllThatStandOutWhereNoVarianceIsKnown) {
  signal::Frf frf;
  frf.H = two_oscillators(0.0).H;
  EXPECT_EQ(peak_lines(frf).size(), 2U);
  frf.variance = Eigen::VectorXd::Zero(frf.H.size());
  EXPECT_EQ(peak_lines(frf).size(), 2U);
}

// A ripple on the flank of a resonance is no resonance there.
TEST(FrfPeaks, FitStaysWithItsLines) {
  const System system = two_oscillators(0.0);
  const Eigen::Index at = peak_lines(system.H.cwiseAbs())[0];
  ASSERT_TRUE(fit_peak(system.s, system.H, at));
  const Eigen::Index right = system.s.size() - at - 20;
  EXPECT_FALSE(fit_peak(system.s.tail(right), system.H.tail(right), 0));
}

// Beside a resonance much higher, behind a valley that is not deep: what is
// fitted is the lower one, not both.
TEST(FrfPeaks, FitEndsInTheValley) {
  System system = two_oscillators(0.0);
  const Complex low = pole_of(31.0, 0.004);
  for (Eigen::Index i = 0; i < system.s.size(); ++i) {
    const Complex s = system.s[i];
    system.H[i] += 0.04 * s * s / ((s - low) * (s - std::conj(low)));
  }
  const auto found = peak_lines(system.H.cwiseAbs());
  ASSERT_EQ(found.size(), 3U);
  const auto fit = fit_peak(system.s, system.H, found[2]);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->frequency_hz(), 31.0, 0.05) << "a line's distance";
}

// One pole and a constant is the model itself: exact.
TEST(FrfPeaks, FitIsExactForOnePole) {
  System system = two_oscillators(0.0);
  const Complex p = pole_of(12.0, 0.01);
  const Complex R{3.0, 40.0};
  const Complex c{-2.0, 0.5};
  for (Eigen::Index i = 0; i < system.s.size(); ++i) {
    system.s[i] += 0.7;
    system.H[i] = c + R / (system.s[i] - p);
  }
  const Eigen::Index peak = peak_lines(system.H.cwiseAbs())[0];
  const auto fit = fit_peak(system.s, system.H, peak);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(std::abs(fit->pole - p), 0.0, 1e-9 * std::abs(p));
  EXPECT_NEAR(std::abs(fit->residue - R), 0.0, 1e-9 * std::abs(R));
  EXPECT_LT(fit->deviation, 1e-9);
  // Every point lies on the circle.
  for (Eigen::Index i = 0; i < system.H.size(); ++i) {
    EXPECT_NEAR(
        std::abs(system.H[i] - fit->centre), fit->radius, 1e-8 * fit->radius);
  }
}

// The other mode and the turn of s^2 are no constant: first order in the
// width of the peak, hence two per cent of the damping.
TEST(FrfPeaks, FitTakesTheWindowsDampingOut) {
  for (const double sigma : {0.0, 0.4}) {
    const System system = two_oscillators(sigma);
    const auto lines = peak_lines(system.H.cwiseAbs());
    ASSERT_EQ(lines.size(), 2U);
    const auto low = fit_peak(system.s, system.H, lines[0]);
    const auto high = fit_peak(system.s, system.H, lines[1]);
    ASSERT_TRUE(low && high);
    EXPECT_NEAR(low->frequency_hz(), 12.0, 1e-4 * 12.0);
    EXPECT_NEAR(low->damping_ratio(), 0.01, 2e-4);
    EXPECT_NEAR(high->frequency_hz(), 27.0, 1e-4 * 27.0);
    EXPECT_NEAR(high->damping_ratio(), 0.008, 2e-4);
  }
}

TEST(FrfPeaks, RefuseWhatIsNoResonance) {
  const System system = two_oscillators(0.0);
  EXPECT_FALSE(fit_peak(system.s.head(4), system.H.head(4), 2));
  EXPECT_FALSE(fit_peak(system.s, system.H, -1));
  EXPECT_FALSE(fit_peak(system.s, system.H, system.H.size()));
  // A pole on the wrong side: energy comes out.
  const Complex p = pole_of(12.0, -0.01);
  Eigen::VectorXcd H = system.H;
  for (Eigen::Index i = 0; i < H.size(); ++i) H[i] = 1.0 / (system.s[i] - p);
  EXPECT_FALSE(fit_peak(system.s, H, peak_lines(H.cwiseAbs())[0]));
  H.setZero();
  EXPECT_FALSE(fit_peak(system.s, H, 100));
}

}  // namespace
}  // namespace tapfit::modal
