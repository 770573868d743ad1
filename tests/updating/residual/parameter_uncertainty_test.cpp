#include "updating/residual/parameter_uncertainty.hpp"

#include "tests/updating/support/plate_experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tapfit::updating {
namespace {

using Eigen::Index;

// The third parameter does what the first two do together. A plain inverse of
// the singular matrix has variances of either sign, as rounding goes.
TEST(ParameterUncertainty, WhatTheDataCannotTellApartIsWideNotExact) {
  const PlateExperiment test({}, 0.01, 3);
  const Target& target = test.fitter().target();
  const Eigen::VectorXd r =
      test.fitter().fit({}, test.fitter().model_for({})).result.residual;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const Eigen::VectorXd open =
      Eigen::VectorXd::Constant(3, std::numeric_limits<double>::infinity());
  for (int round = 0; round < 20; ++round) {
    Eigen::MatrixXd J(r.size(), 3);
    for (Index k = 0; k < r.size(); ++k) {
      J(k, 0) = normal(random);
      J(k, 1) = 0.3 * normal(random);
      J(k, 2) = J(k, 0) + J(k, 1);
    }
    const Eigen::VectorXd variance =
        parameter_covariance(target, J, r, open).diagonal();
    EXPECT_GT(variance.minCoeff(), 1.0) << round;
  }
}

// The deck's error of form drives the second parameter, to ten times what its
// prior allows; with a run for each hit, and with all in one.
TEST(ParameterUncertainty, NothingIsKnownLessThanBeforeItWasMeasured) {
  const PlateExperiment test({}, 0.01, 3);
  Target target = test.fitter().target();
  const Eigen::VectorXd r =
      test.fitter().fit({}, test.fitter().model_for({})).result.residual;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd J(r.size(), 2);
  for (double& value : J.reshaped()) value = normal(random);
  target.form_bias = J.col(1);
  const Eigen::VectorXd open =
      Eigen::VectorXd::Constant(2, std::numeric_limits<double>::infinity());
  for (const bool one_run : {false, true}) {
    if (one_run) target.run.assign(target.run.size(), 0);
    const Eigen::MatrixXd wide = parameter_covariance(target, J, r, open);
    Eigen::VectorXd prior(2);
    prior << 2.0 * std::sqrt(wide(0, 0)), 0.1 * std::sqrt(wide(1, 1));
    const Eigen::MatrixXd held = parameter_covariance(target, J, r, prior);
    EXPECT_NEAR(std::sqrt(held(1, 1)), prior(1), 1e-9 * prior(1)) << one_run;
    EXPECT_LT(std::sqrt(held(0, 0)), prior(0)) << one_run;
    // Shrunk row and column alike: it stays a covariance.
    EXPECT_NEAR(held(0, 1), held(1, 0), 1e-9 * std::abs(held(0, 1)));
    EXPECT_LT(held(0, 1) * held(0, 1), held(0, 0) * held(1, 1)) << one_run;
  }
}

// Of two tests that say the same of a parameter noise counts half; what the
// deck is wrong by, where it is one deck, counts as before.
TEST(ParameterUncertainty, OfTestsTogetherTheDecksErrorDoesNotAverageOut) {
  const PlateExperiment test({}, 0.01, 3);
  Target target = test.fitter().target();
  target.run.assign(target.run.size(), 0);
  const Eigen::VectorXd r =
      test.fitter().fit({}, test.fitter().model_for({})).result.residual;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd J(r.size(), 1);
  for (double& value : J.reshaped()) value = normal(random);
  const Eigen::VectorXd open =
      Eigen::VectorXd::Constant(1, std::numeric_limits<double>::infinity());
  const double noise = parameter_covariance(target, J, r, open)(0, 0);
  const FittedResidual alone{target, J, r, 1};
  EXPECT_NEAR(parameter_covariance({alone, alone}, open)(0, 0),
              0.5 * noise,
              1e-9 * noise);
  target.form_bias = J;
  const double form = parameter_covariance(target, J, r, open)(0, 0) - noise;
  ASSERT_GT(form, noise);
  const FittedResidual one_deck{target, J, r, 1, {0}};
  const FittedResidual another{target, J, r, 1, {1}};
  EXPECT_NEAR(parameter_covariance({one_deck, one_deck}, open)(0, 0),
              0.5 * noise + form,
              1e-9 * form);
  EXPECT_NEAR(parameter_covariance({one_deck, another}, open)(0, 0),
              0.5 * noise + 0.5 * form,
              1e-9 * form);
}

}  // namespace
}  // namespace tapfit::updating
