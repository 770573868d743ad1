#include "updating/diagnosis/evidence.hpp"

#include "updating/residual/independent_data.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;

// FRFs with a residual that is independent from line to line.
double data_of(Index frfs, int modes) {
  const Index lines = 400;
  Target target;
  target.s.resize(lines);
  for (Index l = 0; l < lines; ++l) {
    target.s(l) = {0.1, static_cast<double>(l + 1)};
  }
  std::srand(7);
  const Eigen::MatrixXcd noise = Eigen::MatrixXcd::Random(lines, frfs);
  target.H = noise;
  target.variance = Eigen::MatrixXd::Ones(lines, frfs);
  target.weight = Eigen::VectorXd::Ones(lines);
  target.run.assign(static_cast<std::size_t>(frfs), 0);
  target.use.assign(static_cast<std::size_t>(frfs), 1.0);
  target.modes_in_band = modes;
  return independent_data(target, stack(target, noise));
}

TEST(Evidence, IsWhatModesCanTellHoweverManyLines) {
  // A complex residue of each mode for each FRF, a frequency of each mode.
  EXPECT_DOUBLE_EQ(data_of(1, 1), 3.0);
  EXPECT_DOUBLE_EQ(data_of(1, 4), 12.0);
  EXPECT_DOUBLE_EQ(data_of(6, 4), 52.0);
}

// A fit that leaves so much, and nothing that the form could explain.
Fit leaves(double error) {
  Fit fit;
  fit.form.whole = error * error;
  return fit;
}

TEST(Evidence, OneFrfTellsAMassThatExplainsIt) {
  // One mode, one FRF, 30 % brought to 2 % by one of two candidates.
  const double data = data_of(1, 1);
  const double gained = evidence(leaves(0.02), 1.0, 2.0, data, 0.0).log -
                        evidence(leaves(0.3), 0.0, 1.0, data, 0.0).log;
  // 3 ln 15 less the price of a parameter and of two places: 3 x 2.71 - 0.55 -
  // 0.69.
  EXPECT_NEAR(gained, 6.88, 0.05);
}

TEST(Evidence, APropertyFarFromItsPriorCosts) {
  Fit far = leaves(0.02);
  far.result.prior_cost = 9.0;  // three deviations
  EXPECT_NEAR(evidence(leaves(0.02), 0.0, 1.0, 20.0, 0.0).log -
                  evidence(far, 0.0, 1.0, 20.0, 0.0).log,
              4.5,
              1e-9);
}

// What a usual form may do counts only where next to nothing is left.
TEST(Evidence, OfWhatAUsualFormMayDoIsThatItIsAll) {
  const Evidence with{20.0, 3.0};
  const Evidence without{0.0, 4.0};
  EXPECT_DOUBLE_EQ(log_gain(with, without, 0.5), -1.0);
  EXPECT_DOUBLE_EQ(log_gain(with, without, 0.2), 20.0);
  // What no form explains counts however much is left.
  EXPECT_DOUBLE_EQ(log_gain({9.0, 12.0}, {0.0, 2.0}, 0.9), 10.0);
  EXPECT_DOUBLE_EQ(log_gain({9.0, 12.0}, {0.0, 2.0}, 0.2), 10.0);
}

}  // namespace
}  // namespace tapfit::updating
