#include "acquisition/simulator/exact_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tapfit::acquisition {
namespace {

constexpr double m = 2.0;      // kg
constexpr double k = 8000.0;   // N/m
constexpr double cubic = 3e9;  // N/m^3

/// One mass on a spring and a cubic spring, without damping.
SecondOrderSystem duffing() {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  SecondOrderSystem system{
      m * one, 0.0 * one, k * one, Eigen::VectorXd::Ones(1), one, {}};
  system.hardening = CubicSpring{Eigen::VectorXd::Ones(1), cubic};
  return system;
}

// x + c x^3 swings with T = 4 K(q) / w, w^2 = (k + c A^2) / m and
// q^2 = c A^2 / (2 (k + c A^2)) (for example A. Nayfeh, D. Mook, "Nonlinear
// Oscillations", 1979, sec. 2.1).
double period(double amplitude) {
  const double stiff = k + cubic * amplitude * amplitude;
  const double q = std::sqrt(cubic * amplitude * amplitude / (2.0 * stiff));
  return 4.0 * std::comp_ellint_1(q) / std::sqrt(stiff / m);
}

// Times at which a signal rises through zero, interpolated.
std::vector<double> rises(const Eigen::VectorXd& x, double rate) {
  std::vector<double> times;
  for (Eigen::Index n = 1; n < x.size(); ++n) {
    if (x(n - 1) < 0.0 && x(n) >= 0.0) {
      times.push_back((static_cast<double>(n) - x(n) / (x(n) - x(n - 1))) /
                      rate);
    }
  }
  return times;
}

double swung_period(double rate, double impulse) {
  Eigen::VectorXd force =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2.0 * rate));
  // A triangle of two samples.
  force(1) = impulse * rate;
  const auto response = exact_response(duffing(), force, rate);
  const std::vector<double> times =
      rises(response->acceleration.col(0).tail(force.size() - 3), rate);
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

TEST(Hardening, FreeSwingHasThePeriodOfTheEllipticIntegral) {
  // Energy: m v^2 / 2 = k A^2 / 2 + c A^4 / 4.
  constexpr double impulse = 0.2;
  const double energy = impulse * impulse / (2.0 * m);
  const double amplitude =
      std::sqrt((std::sqrt(k * k + 4.0 * cubic * energy) - k) / cubic);
  // A tenth shorter than without the cubic spring: the effect is there.
  EXPECT_LT(period(amplitude), 0.9 * 2.0 * std::numbers::pi / std::sqrt(k / m));
  const double expected = period(amplitude);
  const double coarse = std::abs(swung_period(4096.0, impulse) / expected - 1);
  const double fine = std::abs(swung_period(16384.0, impulse) / expected - 1);
  // Order h^2: (w h)^2 / 12 is 2e-5 at the coarse rate.
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(fine, 0.15 * coarse + 1e-7);
}

TEST(Hardening, WeakSpringIsNone) {
  SecondOrderSystem system = duffing();
  system.hardening->stiffness = 1e-3;
  SecondOrderSystem linear = system;
  linear.hardening.reset();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2000);
  force.segment(5, 20).setConstant(3.0);
  const Eigen::MatrixXd a = exact_response(system, force, 2000.0)->acceleration;
  const Eigen::MatrixXd b = exact_response(linear, force, 2000.0)->acceleration;
  EXPECT_LT((a - b).norm(), 1e-10 * b.norm());
}

TEST(Hardening, StiffModesAreFeltAtItsPlace) {
  // Two masses in a row; the upper mode is static in one run and stepped
  // through in the other.
  SecondOrderSystem system;
  system.M = Eigen::Vector2d(1.0, 0.01).asDiagonal();
  system.K =
      (Eigen::Matrix2d() << 60000.0, -50000.0, -50000.0, 50000.0).finished();
  system.C = 1e-5 * system.K;
  system.input = Eigen::Vector2d(1.0, 0.0);
  system.output = Eigen::RowVector2d(1.0, 0.0);
  system.hardening = CubicSpring{Eigen::Vector2d(0.0, 1.0), 3e8};
  constexpr double rate = 32768.0;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(16384);
  for (Eigen::Index n = 0; n < 400; ++n) {
    const double turn = std::numbers::pi * static_cast<double>(n) / 400.0;
    force(n) = 60.0 * std::pow(std::sin(turn), 2);
  }
  const Eigen::MatrixXd all = exact_response(system, force, rate)->acceleration;
  const Eigen::MatrixXd some =
      exact_response(system, force, rate, 100.0)->acceleration;
  SecondOrderSystem linear = system;
  linear.hardening.reset();
  const Eigen::MatrixXd none =
      exact_response(linear, force, rate)->acceleration;
  EXPECT_GT((all - none).norm(), 0.3 * all.norm());
  // The upper mode, at 357 Hz, is hit at 80 Hz at most.
  EXPECT_LT((all - some).norm(), 0.02 * all.norm());
}

}  // namespace
}  // namespace tapfit::acquisition
