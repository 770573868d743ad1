#include "updating/localisation/absorber_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace tapfit::updating {
namespace {

// Lines from 5 to 60 Hz on s = 2 + j w.
Eigen::VectorXcd lines() {
  Eigen::VectorXcd s(221);
  for (Eigen::Index l = 0; l < s.size(); ++l) {
    const double hz = 5.0 + 0.25 * static_cast<double>(l);
    s(l) = {2.0, 2.0 * std::numbers::pi * hz};
  }
  return s;
}

TEST(AbsorberLaw, IsTheStiffnessOfAMassOnASpring) {
  // Far below its resonance it is a mass, far above it holds still: a spring
  // and a dashpot to the ground.
  const AbsorberLaw absorber{0.05, 20.0, 0.02, 0.0};
  const double w = 2.0 * std::numbers::pi * 20.0;
  Eigen::VectorXcd s(2);
  s << std::complex<double>{0.0, 1e-3 * w}, std::complex<double>{0.0, 1e3 * w};
  const Eigen::VectorXcd z = absorber_stiffness(absorber, s);
  // (w / w0)^2 = 1e-6 of it is left out on either side.
  EXPECT_NEAR(std::abs(z(0) / (0.05 * s(0) * s(0)) - 1.0), 0.0, 1e-5);
  const std::complex<double> held = 0.05 * (2.0 * 0.02 * w * s(1) + w * w);
  EXPECT_NEAR(std::abs(z(1) / held - 1.0), 0.0, 1e-3);
}

TEST(AbsorberLaw, IsFoundUnderScatter) {
  const AbsorberLaw built{0.05, 23.4, 0.03, 0.0};
  const Eigen::VectorXcd s = lines();
  Eigen::VectorXcd z = absorber_stiffness(built, s);
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.02 * z.cwiseAbs().mean());
  for (std::complex<double>& value : z)
    value += std::complex(normal(random), normal(random));
  const Eigen::VectorXd weight = Eigen::VectorXd::Ones(s.size());
  const AbsorberLaw found = fit_absorber(z, weight, s);
  // 2 % of the mean on 221 lines, of which some twenty tell the resonance.
  EXPECT_NEAR(found.mass_kg, 0.05, 0.001);
  EXPECT_NEAR(found.frequency_hz, 23.4, 0.1);
  EXPECT_NEAR(found.damping_ratio, 0.03, 0.003);
  EXPECT_LT(found.unexplained, 0.05);
  const double as_mass = fit_law(z, weight, s.cwiseProduct(s)).unexplained;
  EXPECT_GT(as_mass, 0.5) << "no law without a resonance explains it";
}

// A mass is an absorber that resonates beyond all lines.
TEST(AbsorberLaw, ResonatesOnTheLines) {
  const Eigen::VectorXcd s = lines();
  const AbsorberLaw found = fit_absorber(
      0.05 * s.cwiseProduct(s), Eigen::VectorXd::Ones(s.size()), s);
  EXPECT_GE(found.frequency_hz, 5.0);
  EXPECT_LE(found.frequency_hz, 60.0);
}

TEST(AbsorberLaw, IsNoneWhereNothingIsMissing) {
  const Eigen::VectorXcd s = lines();
  const AbsorberLaw none = fit_absorber(
      Eigen::VectorXcd::Zero(s.size()), Eigen::VectorXd::Ones(s.size()), s);
  EXPECT_EQ(none.mass_kg, 0.0);
  EXPECT_EQ(none.unexplained, 1.0);
}

}  // namespace
}  // namespace tapfit::updating
