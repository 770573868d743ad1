#include "updating/fit/fitted_form.hpp"

#include "tests/updating/support/plate_experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// The columns that all modes have in common, evenly and by their frequency, are
// the last but one of FRFs, and the last of modes: half as much again as a
// careful deck's modes differ.
TEST(LikelyFormBias, HoldsWhatNoResidualTells) {
  const FormError patterns{MatrixXd::Ones(4, 6), Eigen::VectorXd::Zero(6)};
  const double small = 0.1 * middle_tau;
  Target target;
  const MatrixXd frfs = likely_form_bias(patterns, small, 1.0, target);
  for (const Index k : {0, 1, 2, 5}) EXPECT_DOUBLE_EQ(frfs(0, k), small);
  for (const Index k : {3, 4}) EXPECT_DOUBLE_EQ(frfs(0, k), 1.5 * middle_tau);
  target.modal_sd = 1e-3;
  const MatrixXd modes = likely_form_bias(patterns, small, 2.0, target);
  for (const Index k : {0, 3}) EXPECT_DOUBLE_EQ(modes(0, k), small);
  for (const Index k : {4, 5}) EXPECT_DOUBLE_EQ(modes(0, k), 3.0 * middle_tau);
}

TEST(LikelyFormBias, FollowsAResidualThatTellsMore) {
  const FormError patterns{MatrixXd::Ones(4, 6), Eigen::VectorXd::Zero(6)};
  const MatrixXd bias =
      likely_form_bias(patterns, 3.0 * middle_tau, 1.0, Target{});
  EXPECT_TRUE(bias.isConstant(3.0 * middle_tau));
}

TEST(LikelyFormBias, HoldsWhatTheMeshLeavesOfAMode) {
  FormError patterns{MatrixXd::Ones(4, 6), Eigen::VectorXd::Zero(6)};
  patterns.mesh_sd(1) = 4.0 * middle_tau;
  const MatrixXd bias =
      likely_form_bias(patterns, 3.0 * middle_tau, 1.0, Target{});
  EXPECT_DOUBLE_EQ(bias(0, 0), 3.0 * middle_tau);
  EXPECT_DOUBLE_EQ(bias(0, 1), 5.0 * middle_tau);
}

// What all modes have in common evenly is what the one modulus of the plate
// does: the third column from the end. Damping, which the pattern leaves as it
// is and a ratio does not, is most of the rest.
TEST(FormBias, HoldsTheModulusThirdFromTheEnd) {
  const PlateExperiment test{{}, 0.01, 3};
  const Fitter& fitter = test.fitter();
  const Fit fit = fitter.fit({}, fitter.model_for({}));
  const MatrixXd F =
      form_error(*fit.model, fit.result.state, fitter.target()).F;
  const Eigen::VectorXd by_modulus = fit.result.jacobian.col(0);
  Index nearest = 0;
  (F.colwise().normalized().transpose() * by_modulus)
      .cwiseAbs()
      .maxCoeff(&nearest);
  EXPECT_EQ(nearest, F.cols() - 3);
  EXPECT_GT(std::abs(F.col(nearest).normalized().dot(by_modulus.normalized())),
            0.99);
}

}  // namespace
}  // namespace tapfit::updating
