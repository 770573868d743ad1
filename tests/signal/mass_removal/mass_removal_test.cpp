#include "signal/mass_removal/mass_removal.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace tapfit::signal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// One sensor at the driving point: A_ii alone is wanted, row, column and core.
MassRemoval at_driving_point(const Eigen::VectorXcd& H,
                             const Eigen::VectorXd& variance,
                             double kg,
                             double sd_kg) {
  const LoadedEntry entry{&H, &variance, 1.0, 0};
  MassRemoval removal;
  removal.wanted = entry;
  removal.row = {entry};
  removal.column = {entry};
  removal.core = {entry};
  removal.kg = Eigen::VectorXd::Constant(1, kg);
  removal.sd_kg = Eigen::VectorXd::Constant(1, sd_kg);
  removal.mass = {0};
  return removal;
}

Eigen::VectorXcd lines(double low_hz, double high_hz, Index count) {
  Eigen::VectorXcd s(count);
  for (Index k = 0; k < count; ++k) {
    const double f = low_hz + (high_hz - low_hz) * static_cast<double>(k) /
                                  static_cast<double>(count - 1);
    s(k) = {0.4, 2.0 * std::numbers::pi * f};
  }
  return s;
}

/// A = s^2 / (k + c s + M s^2)
Eigen::VectorXcd one_dof(const Eigen::VectorXcd& s, double kg) {
  constexpr double k = 4e3;
  constexpr double c = 1.5;
  return s.array().square() / (k + c * s.array() + kg * s.array().square());
}

TEST(MassRemoval, GivesTheBareOscillatorBack) {
  const Eigen::VectorXcd s = lines(1.0, 30.0, 50);
  const Eigen::VectorXcd loaded = one_dof(s, 0.5 + 0.08);
  const auto freed = remove_masses(at_driving_point(loaded, {}, 0.08, 0.0));
  ASSERT_TRUE(freed.has_value());
  // Closed form; what is left is rounding.
  EXPECT_LT((freed->H - one_dof(s, 0.5)).norm(), 1e-12 * loaded.norm());
}

/// State (w, w', M, Q) over a beam of length l; see W. Weaver, S. Timoshenko,
/// D. Young, "Vibration Problems in Engineering", 5th ed., ch. 5.
Eigen::Matrix4cd transfer(Complex beta, Complex EI, double l) {
  const Complex x = beta * l;
  const Complex a = 0.5 * (std::cosh(x) + std::cos(x));
  const Complex b = 0.5 * (std::sinh(x) + std::sin(x)) / beta;
  const Complex c = 0.5 * (std::cosh(x) - std::cos(x)) / (beta * beta);
  const Complex d = 0.5 * (std::sinh(x) - std::sin(x)) / (beta * beta * beta);
  const Complex b4 = beta * beta * beta * beta;
  Eigen::Matrix4cd T;
  T << a, b, c / EI, d / EI, b4 * d, a, b / EI, c / EI, b4 * c * EI,
      b4 * d * EI, a, b, b4 * b * EI, b4 * c * EI, b4 * d, a;
  return T;
}

/// A cantilever with point masses half way and at the tip, solved as a boundary
/// value problem: exact, and nothing of Sherman and Morrison in it.
struct Cantilever {
  double middle_kg = 0.0;
  double tip_kg = 0.0;

  /// Accelerances [middle, tip] to a unit force at `place`.
  [[nodiscard]] Eigen::Vector2cd respond(Complex s, int place) const {
    constexpr double length = 0.5;
    constexpr double kg_per_m = 0.486;
    const Complex EI = Complex(3.15, 0.02);
    const Complex beta = std::pow(-s * s * kg_per_m / EI, 0.25);
    const Eigen::Matrix4cd half = transfer(beta, EI, 0.5 * length);
    Eigen::Matrix4cd mass = Eigen::Matrix4cd::Identity();
    // Q = EI w''' jumps by F - m s^2 w where a force and a mass are.
    mass(3, 0) = -middle_kg * s * s;
    const Eigen::Matrix4cd all = half * mass * half;
    Eigen::Vector4cd jump = Eigen::Vector4cd::Zero();
    if (place == 0) jump = half.col(3);
    // Free tip: M = 0 and Q + F_tip - tip_kg s^2 w = 0.
    Eigen::Matrix2cd L;
    Eigen::Vector2cd right;
    for (Index c = 0; c < 2; ++c) {
      L(0, c) = all(2, c + 2);
      L(1, c) = all(3, c + 2) - tip_kg * s * s * all(0, c + 2);
    }
    right(0) = -jump(2);
    right(1) = -(jump(3) - tip_kg * s * s * jump(0));
    if (place == 1) right(1) -= 1.0;
    const Eigen::Vector2cd root = L.fullPivLu().solve(right);
    const Complex middle = (half * Eigen::Vector4cd(0, 0, root(0), root(1)))(0);
    const Complex tip =
        (all * Eigen::Vector4cd(0, 0, root(0), root(1)) + jump)(0);
    return s * s * Eigen::Vector2cd(middle, tip);
  }
};

TEST(MassRemoval, TransferMatrixHasTheCantileversFirstFrequency) {
  // cos x cosh x = -1 at x = 1.875104, w = x^2 sqrt(EI / (m l^4)): the test's
  // own beam is right. Undamped it would be infinite there.
  const double w = std::pow(1.8751041, 2) * std::sqrt(3.15 / 0.486) / 0.25;
  const Cantilever bare;
  const double at = std::abs(bare.respond({0.0, w}, 1)(1));
  EXPECT_GT(at, 20.0 * std::abs(bare.respond({0.0, 0.8 * w}, 1)(1)));
  EXPECT_GT(at, std::abs(bare.respond({0.0, 1.005 * w}, 1)(1)));
  EXPECT_GT(at, std::abs(bare.respond({0.0, 0.995 * w}, 1)(1)));
}

TEST(MassRemoval, TakesTwoSensorsOffABeamAtOnce) {
  const Cantilever loaded{0.02, 0.03};
  const Cantilever bare;
  const Eigen::VectorXcd s = lines(2.0, 300.0, 60);
  std::vector<Eigen::VectorXcd> A(4, Eigen::VectorXcd(s.size()));
  for (Index k = 0; k < s.size(); ++k) {
    for (std::size_t from = 0; from < 2; ++from) {
      const Eigen::Vector2cd a = loaded.respond(s(k), static_cast<int>(from));
      A[from](k) = a(0);
      A[2 + from](k) = a(1);
    }
  }
  const Eigen::VectorXd none;
  const auto entry = [&](std::size_t f) {
    return LoadedEntry{&A[f], &none, 1.0, f};
  };
  MassRemoval removal;
  removal.wanted = entry(1);  // middle / tip
  removal.row = {entry(0), entry(1)};
  removal.column = {entry(1), entry(3)};
  removal.core = {entry(0), entry(1), entry(2), entry(3)};
  removal.kg = Eigen::Vector2d(0.02, 0.03);
  removal.sd_kg = Eigen::Vector2d::Zero();
  removal.mass = {0, 1};
  const auto freed = remove_masses(removal);
  ASSERT_TRUE(freed.has_value());
  for (Index k = 0; k < s.size(); ++k) {
    const Complex exact = bare.respond(s(k), 1)(0);
    // cosh reaches e^12 at the band's end: rounding grows to 1e-16 e^12.
    EXPECT_LT(std::abs(freed->H(k) - exact), 1e-8 * std::abs(exact)) << k;
    EXPECT_GT(std::abs(A[1](k) - exact), 1e-4 * std::abs(exact)) << k;
  }
}

TEST(MassRemoval, SaysWhenNothingWouldBeLeft) {
  // A free body of the sensor's own mass: A = 1 / m.
  const Eigen::VectorXcd H = Eigen::VectorXcd::Constant(3, 1.0 / 0.25);
  EXPECT_FALSE(remove_masses(at_driving_point(H, {}, 0.25, 0.0)).has_value());
}

TEST(MassRemoval, VarianceOfADrivingPointIsThatOfTheClosedForm) {
  // A0 = A / (1 - m A): dA0/dA = 1 / (1 - m A)^2, dA0/dm = A0^2.
  const Eigen::VectorXcd H = Eigen::VectorXcd::Constant(1, {3.0, -4.0});
  const Eigen::VectorXd v = Eigen::VectorXd::Constant(1, 0.01);
  const auto freed = remove_masses(at_driving_point(H, v, 0.05, 0.002));
  ASSERT_TRUE(freed.has_value());
  const Complex den = 1.0 - 0.05 * H(0);
  const double expected =
      0.01 / std::norm(den * den) +
      std::pow(0.002, 2) * std::norm(H(0) * H(0) / (den * den));
  EXPECT_NEAR(freed->variance(0), expected, 1e-12 * expected);
}

/// Share of seeds in which the true A0 lies within the 95 % circle.
double coverage(double noise, double sd_kg) {
  const Eigen::VectorXcd s = lines(1.0, 30.0, 40);
  constexpr double sensor = 0.05;
  const Eigen::VectorXcd bare = one_dof(s, 0.5);
  const Eigen::VectorXcd loaded = one_dof(s, 0.5 + sensor);
  std::normal_distribution<double> normal;
  int inside = 0;
  int all = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937_64 random(seed);
    Eigen::VectorXcd H = loaded;
    Eigen::VectorXd variance(s.size());
    for (Index k = 0; k < s.size(); ++k) {
      const double sd = noise * std::abs(loaded(k));
      variance(k) = sd * sd;
      H(k) +=
          sd / std::numbers::sqrt2 * Complex(normal(random), normal(random));
    }
    const double stated = sensor + sd_kg * normal(random);
    const auto freed =
        remove_masses(at_driving_point(H, variance, stated, sd_kg));
    for (Index k = 0; freed && k < s.size(); ++k) {
      // |e|^2 / E|e|^2 of a circular error is below -ln 0.05 in 95 %.
      const double limit = -std::log(0.05) * freed->variance(k);
      if (std::norm(freed->H(k) - bare(k)) <= limit) ++inside;
      ++all;
    }
  }
  return static_cast<double>(inside) / all;
}

TEST(MassRemoval, StatesAnUncertaintyThatHolds) {
  // 4000 independent lines: three standard deviations of the share are 0.010.
  EXPECT_NEAR(coverage(0.01, 0.0), 0.95, 0.012);
  // One error of the mass for all lines of a seed, along one direction of the
  // plane (91.7 % in the same circle), 100 seeds: 0.083.
  EXPECT_NEAR(coverage(1e-6, 0.001), 0.917, 0.083);
  EXPECT_NEAR(coverage(0.01, 0.0005), 0.94, 0.05);
}

}  // namespace
}  // namespace tapfit::signal
