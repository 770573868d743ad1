#include "modal/mass_loading/explain_shifts.hpp"

#include "modal/mass_loading/unloaded_modes.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tapfit::modal {
namespace {

using Eigen::Index;

struct Case {
  Index set_ups = 8;
  Index modes = 6;
  Index beyond = 6;          // modes above the band, with their own shapes
  double m1 = 0.0;           // of the first sensor [kg]
  double m2 = 0.0;           // of the second
  double noise = 1e-5;       // sd of ln w as stated
  double noise_factor = 1;   // true sd over stated
  double common = 0.0;       // rms of a fraction common to a set-up's modes
  double other = 0.0;        // rms of shifts of each pole of its own
  double shape_noise = 0.0;  // of each value of a shape, relative
  double scale_noise = 0.0;  // of each shape as a whole
  bool scaled = true;
};

/// Poles of a structure of random shapes with two roving sensors, exact by the
/// eigenproblem of the loaded structure in all of its modes.
ShiftData generate(const Case& c, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Index all = c.modes + c.beyond;
  const Eigen::VectorXd log_free =
      Eigen::VectorXd::NullaryExpr(all, [&](Index r) {
        return std::log(100.0 * (1.0 + static_cast<double>(r))) +
               0.05 * normal(random);
      });
  ShiftData data;
  data.scaled = c.scaled;
  data.damping = Eigen::VectorXd::Constant(c.modes, 0.005);
  data.log_omega.resize(c.set_ups, c.modes);
  data.log_sd = Eigen::MatrixXd::Constant(c.set_ups, c.modes, c.noise);
  data.scale_sd = Eigen::VectorXd::Constant(c.modes, c.scale_noise);
  data.hammer.assign(static_cast<std::size_t>(c.set_ups),
                     Eigen::MatrixXd(0, c.modes));
  data.phi.resize(2);
  data.phi_sd.resize(2);
  const Eigen::VectorXd unit = Eigen::VectorXd::NullaryExpr(c.modes, [&] {
    const double x = normal(random);
    return c.scaled ? 1.0 + c.scale_noise * x : std::exp(x);
  });
  for (Index k = 0; k < c.set_ups; ++k) {
    const Eigen::MatrixXd phi =
        Eigen::MatrixXd::NullaryExpr(2, all, [&] { return normal(random); });
    // The loaded structure by its definition; eigenvectors have v' M v = 1 and
    // frequencies are too far apart to change places.
    const Eigen::MatrixXd M =
        Eigen::MatrixXd::Identity(all, all) +
        phi.transpose() * Eigen::Vector2d(c.m1, c.m2).asDiagonal() * phi;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> loaded(
        (2.0 * log_free.array()).exp().matrix().asDiagonal().toDenseMatrix(),
        M);
    const Eigen::MatrixXd shapes = phi * loaded.eigenvectors();
    const double shared = c.common * normal(random);
    for (Index r = 0; r < c.modes; ++r) {
      data.log_omega(k, r) = 0.5 * std::log(loaded.eigenvalues()(r)) + shared +
                             c.other * normal(random) +
                             c.noise * c.noise_factor * normal(random);
    }
    for (Index q = 0; q < 2; ++q) {
      Eigen::MatrixXd own = shapes.row(q).head(c.modes);
      for (Index r = 0; r < c.modes; ++r) {
        own(0, r) =
            unit(r) * own(0, r) * (1.0 + c.shape_noise * normal(random));
      }
      data.phi_sd[static_cast<std::size_t>(q)].push_back(c.shape_noise *
                                                         own.cwiseAbs());
      data.phi[static_cast<std::size_t>(q)].push_back(own);
    }
  }
  return data;
}

/// Largest distance of the sorted values from a uniform distribution.
double kolmogorov(std::vector<double> p) {
  std::ranges::sort(p);
  double largest = 0.0;
  const auto n = static_cast<double>(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto before = static_cast<double>(i);
    largest = std::max({largest,
                        std::abs(p[i] - before / n),
                        std::abs(p[i] - (before + 1.0) / n)});
  }
  return largest;
}

void expect_silent_under(const Case& c) {
  std::vector<double> p;
  int alarms = 0;
  constexpr unsigned seeds = 400;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const auto shifts = explain_shifts(generate(c, seed));
    ASSERT_TRUE(shifts.has_value());
    p.push_back(shifts->p_mass);
    if (shifts->cause == ShiftCause::SensorMass) ++alarms;
  }
  // Kolmogorov's 1 % limit is 1.63 / sqrt(n) for one sample.
  EXPECT_LT(kolmogorov(p), 1.63 / std::sqrt(seeds));
  // One in a hundred by its p, half of them of a negative mass: 2 expected.
  EXPECT_LE(alarms, 8);
}

TEST(PoleShifts, SaysNothingOfNoise) { expect_silent_under({}); }

TEST(PoleShifts, SaysNothingOfNoiseLargerThanStated) {
  Case c;
  c.noise_factor = 20.0;
  expect_silent_under(c);
}

TEST(PoleShifts, SaysNothingOfMassesWhenTemperatureMovesAllModes) {
  Case c;
  c.common = 3e-3;
  expect_silent_under(c);
}

TEST(PoleShifts, SaysNothingOfNoiseWithoutAScale) {
  Case c;
  c.scaled = false;
  expect_silent_under(c);
}

TEST(PoleShifts, TellsASharedFraction) {
  Case c;
  c.common = 3e-3;
  const auto shifts = explain_shifts(generate(c, 3));
  ASSERT_TRUE(shifts.has_value());
  EXPECT_EQ(shifts->cause, ShiftCause::SameFraction);
  EXPECT_LT(shifts->p_same_fraction, 1e-6);
  EXPECT_GT(shifts->explained, 0.99);
}

TEST(PoleShifts, TellsShiftsThatAreLikeNeither) {
  Case c;
  c.other = 3e-3;
  const auto shifts = explain_shifts(generate(c, 3));
  ASSERT_TRUE(shifts.has_value());
  EXPECT_EQ(shifts->cause, ShiftCause::Unknown);
  EXPECT_LT(shifts->p_noise, 1e-6);
  EXPECT_TRUE(shifts->masses.empty());
}

/// Share of seeds whose 95 % interval holds the mass.
double coverage(const Case& c, double& bias) {
  int inside = 0;
  int found = 0;
  bias = 0.0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const auto shifts = explain_shifts(generate(c, seed));
    if (!shifts || shifts->masses.size() != 1) continue;
    ++found;
    const MassEstimate& mass = shifts->masses[0];
    bias += (mass.kg / c.m1 - 1.0) / 200.0;
    if (mass.lo95_kg <= c.m1 && c.m1 <= mass.hi95_kg) ++inside;
  }
  EXPECT_GE(found, 190);  // two masses by chance in one of a hundred
  return static_cast<double>(inside) / found;
}

TEST(PoleShifts, FindsASmallMassWithAnIntervalThatHolds) {
  Case c;
  c.m1 = c.m2 = 5e-4;  // shifts of 0.03 %, second order of 1e-7
  c.noise = 2e-5;
  double bias = 0.0;
  // Three standard deviations of a share of 200 at 95 % are 4.6 %.
  EXPECT_NEAR(coverage(c, bias), 0.95, 0.047);
  EXPECT_LT(std::abs(bias), 0.01);
}

TEST(PoleShifts, FindsAMassThroughShapeErrors) {
  Case c;
  c.m1 = c.m2 = 2e-3;
  c.noise = 1e-5;
  c.shape_noise = 0.02;
  c.scale_noise = 0.02;
  double bias = 0.0;
  // Errors of the shapes also stand in what they are fitted to, so that the
  // interval is an approximation: 90 to 99 %.
  EXPECT_NEAR(coverage(c, bias), 0.945, 0.05);
  EXPECT_LT(std::abs(bias), 0.02);
}

TEST(PoleShifts, FindsALargeMassWithAnIntervalThatHolds) {
  Case c;
  c.m1 = c.m2 = 1e-2;  // shifts of 1 %, up to 10 %
  double bias = 0.0;
  // What the modes out of the band do is no noise but one bias for all poles,
  // known in size only: the interval is an approximation.
  EXPECT_GE(coverage(c, bias), 0.85);
  EXPECT_LT(std::abs(bias), 0.05);
}

TEST(PoleShifts, FindsAMassBesideTemperature) {
  Case c;
  c.m1 = c.m2 = 1e-3;
  const ShiftData still = generate(c, 5);
  c.common = 1e-3;
  const ShiftData moved = generate(c, 5);
  const auto shifts = explain_shifts(moved);
  ASSERT_TRUE(shifts.has_value());
  EXPECT_EQ(shifts->cause, ShiftCause::SensorMass);
  ASSERT_EQ(shifts->masses.size(), 1U);
  // Noise 1e-5 on shifts of 5e-4, 30 of them: 0.4 %; the rest is second order.
  EXPECT_NEAR(shifts->masses[0].kg, 1e-3, 2e-5);
  Eigen::VectorXd common = (moved.log_omega - still.log_omega).rowwise().mean();
  common.array() -= common.mean();
  // Noise 1e-5 over the root of six modes.
  EXPECT_NEAR(shifts->same_fraction, common.norm() / std::sqrt(7.0), 1e-5);
}

TEST(PoleShifts, TellsSensorsOfDifferentMassApart) {
  Case c;
  c.m1 = 1e-3;
  c.m2 = 2e-3;
  const auto shifts = explain_shifts(generate(c, 5));
  ASSERT_TRUE(shifts.has_value());
  ASSERT_EQ(shifts->masses.size(), 2U);
  // As above.
  EXPECT_NEAR(shifts->masses[0].kg, 1e-3, 2e-5);
  EXPECT_NEAR(shifts->masses[1].kg, 2e-3, 4e-5);
}

TEST(PoleShifts, KnowsTheCauseButNotTheMassWithoutAScale) {
  Case c;
  c.m1 = c.m2 = 2e-3;
  c.scaled = false;
  const auto shifts = explain_shifts(generate(c, 5));
  ASSERT_TRUE(shifts.has_value());
  EXPECT_EQ(shifts->cause, ShiftCause::SensorMass);
  EXPECT_GT(shifts->explained, 0.95);
  EXPECT_TRUE(shifts->masses.empty());
}

TEST(PoleShifts, IsNotTakenInByOnePoleThatIsWrong) {
  Case c;
  c.m1 = c.m2 = 1e-3;
  ShiftData data = generate(c, 5);
  data.log_omega(3, 2) += 0.02;  // another mode, taken for this one
  const auto shifts = explain_shifts(data);
  ASSERT_TRUE(shifts.has_value());
  ASSERT_EQ(shifts->masses.size(), 1U);
  // Without robustness it is off by half.
  EXPECT_NEAR(shifts->masses[0].kg, 1e-3, 1e-4);
}

TEST(PoleShifts, WorksWithPolesMissing) {
  Case c;
  c.m1 = c.m2 = 1e-3;
  ShiftData data = generate(c, 5);
  data.log_sd(0, 0) = 0.0;
  data.log_sd(4, 3) = 0.0;
  data.log_sd.col(5).tail(7).setZero();
  const auto shifts = explain_shifts(data);
  ASSERT_TRUE(shifts.has_value());
  ASSERT_EQ(shifts->masses.size(), 1U);
  EXPECT_NEAR(shifts->masses[0].kg, 1e-3, 2e-5);
}

TEST(PoleShifts, HasNothingToSayOfTooLittle) {
  Case c;
  c.set_ups = 2;
  c.modes = 1;
  EXPECT_FALSE(explain_shifts(generate(c, 1)).has_value());
}

TEST(UnloadedModes, UndoesALoadThatItKnowsAllModesOf) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd phi =
      Eigen::MatrixXd::NullaryExpr(2, 5, [&] { return normal(random); });
  const Eigen::VectorXd squares = Eigen::VectorXd::LinSpaced(5, 1e4, 9e4);
  // The loaded structure by its definition, K v = w^2 (I + m phi' phi) v.
  const Eigen::MatrixXd M =
      Eigen::MatrixXd::Identity(5, 5) + 0.05 * phi.transpose() * phi;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> loaded(
      squares.asDiagonal().toDenseMatrix(), M);
  const Eigen::MatrixXd shapes = phi * loaded.eigenvectors();
  const auto back = unload(0.5 * loaded.eigenvalues().array().log().matrix(),
                           {shapes},
                           Eigen::VectorXd::Constant(1, 0.05));
  ASSERT_TRUE(back.has_value());
  Eigen::VectorXd sorted = back->log_omega;
  std::ranges::sort(sorted);
  // All modes are there: exact but for rounding.
  EXPECT_LT((sorted - 0.5 * squares.array().log().matrix()).norm(), 1e-12);
}

TEST(UnloadedModes, DerivativeIsThatOfDifferences) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd phi =
      Eigen::MatrixXd::NullaryExpr(1, 4, [&] { return normal(random); });
  const Eigen::VectorXd log_omega = Eigen::VectorXd::LinSpaced(4, 4.0, 5.0);
  const auto at = [&](double kg) {
    return unload(log_omega, {phi}, Eigen::VectorXd::Constant(1, kg));
  };
  constexpr double h = 1e-5;
  const Eigen::VectorXd slope =
      (at(0.02 + h)->log_omega - at(0.02 - h)->log_omega) / (2.0 * h);
  // Central differences: h^2 times a third derivative of about 10.
  EXPECT_LT((at(0.02)->derivative.col(0) - slope).norm(), 1e-7);
}

TEST(UnloadedModes, RefusesMoreMassThanThereIs) {
  EXPECT_FALSE(unload(Eigen::Vector2d(1.0, 2.0),
                      {Eigen::MatrixXd::Ones(1, 2)},
                      Eigen::VectorXd::Constant(1, 0.6))
                   .has_value());
}

}  // namespace
}  // namespace tapfit::modal
