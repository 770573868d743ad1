// Shares of a chain's springs and masses from its modes.
#include "updating/modal_updating/modal_updater.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/spring_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;
using support::chain;
using support::measure;

constexpr double kNone = std::numeric_limits<double>::infinity();

Prior no_prior(Index n) {
  return {VectorXd::Zero(n),
          VectorXd::Constant(n, kNone),
          VectorXd::Constant(n, -0.9),
          VectorXd::Constant(n, 5.0)};
}

TEST(ModalUpdater, RecoversAChainExactly) {
  const ScaledModel model = chain(10);
  VectorXd truth(10);
  truth << -0.3, 0.2, 0.0, 0.5, -0.1, 0.1, -0.4, 0.3, 0.05, -0.2;
  const ModalUpdate found = modal_update(
      model, measure(model, truth, 5, 2), no_prior(10), VectorXd::Zero(10));
  EXPECT_TRUE(found.converged) << found.message;
  EXPECT_LT((found.theta - truth).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_GT(found.after.mac.minCoeff(), 1.0 - 1e-9);
  EXPECT_LT(found.before.mac.minCoeff(), 0.99);
  for (std::size_t k = 1; k < found.history.size(); ++k) {
    EXPECT_LT(found.history[k].objective, found.history[k - 1].objective);
  }
}

TEST(ModalUpdater, RecoversMassesAlong) {
  // Springs and masses scale together unseen; one known spring settles it.
  ScaledModel model = chain(5, 5);
  model.parts.erase(model.parts.begin());
  VectorXd truth(9);
  truth << 0.2, -0.1, 0.3, -0.2, 0.1, -0.15, 0.25, 0.0, -0.05;
  const ModalUpdate found = modal_update(
      model, measure(model, truth, 5), no_prior(9), VectorXd::Zero(9));
  EXPECT_TRUE(found.converged) << found.message;
  EXPECT_LT((found.theta - truth).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(ModalUpdater, RecoversAFreeChain) {
  ScaledModel model = chain(6);
  model.K0 -= model.parts.front().K;
  model.parts.erase(model.parts.begin());
  VectorXd truth(5);
  truth << 0.2, -0.1, 0.3, -0.2, 0.1;
  // The rigid mode is not among the measured ones.
  MeasuredModes measured = measure(model, truth, 4);
  measured.frequency_hz = measured.frequency_hz.tail(3).eval();
  measured.frequency_sd = measured.frequency_sd.tail(3).eval();
  measured.shape = measured.shape.rightCols(3).eval();
  measured.shape_sd = measured.shape_sd.rightCols(3).eval();
  const ModalUpdate found =
      modal_update(model, measured, no_prior(5), VectorXd::Zero(5));
  EXPECT_TRUE(found.converged) << found.message;
  EXPECT_LT((found.theta - truth).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(ModalUpdater, PairsModesThatChangePlaces) {
  // Two chains that do not touch: stiffening the first puts its mode above the
  // second's, and by order of frequency alone the answer would be none.
  ScaledModel model;
  MatrixXd first = MatrixXd::Zero(2, 2);
  MatrixXd second = MatrixXd::Zero(2, 2);
  first(0, 0) = 5000.0;
  second(1, 1) = 5000.0;
  MatrixXd K = first + 1.2 * second;
  K(0, 1) = K(1, 0) = -50.0;
  model.K0 = K.sparseView();
  model.M0 = MatrixXd(2.0 * MatrixXd::Identity(2, 2)).sparseView();
  model.parts = {{"first", first.sparseView()},
                 {"second", second.sparseView()}};
  VectorXd truth(2);
  truth << 0.6, 0.1;
  const MeasuredModes measured = measure(model, truth, 2);
  const ModalUpdate found =
      modal_update(model, measured, no_prior(2), VectorXd::Zero(2));
  EXPECT_EQ(found.before.pairs[0].model, 1);
  EXPECT_EQ(found.after.pairs[0].model, 0);
  EXPECT_LT((found.theta - truth).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(ModalUpdater, WorksFromFrequenciesAlone) {
  const ScaledModel model = chain(3);
  VectorXd truth(3);
  truth << 0.1, -0.05, 0.08;
  MeasuredModes measured = measure(model, truth, 3);
  measured.dofs.clear();
  const ModalUpdate found =
      modal_update(model, measured, no_prior(3), VectorXd::Zero(3));
  EXPECT_TRUE(found.converged) << found.message;
  EXPECT_LT((found.after.frequency_hz - measured.frequency_hz)
                .cwiseQuotient(measured.frequency_sd)
                .norm(),
            1e-4);
  EXPECT_EQ(found.after.mac.norm(), 0.0);
}

TEST(ModalUpdater, SaysWhatTheDataDoNotTell) {
  // One frequency for three springs.
  const ScaledModel model = chain(3);
  MeasuredModes measured = measure(model, VectorXd::Constant(3, 0.1), 1);
  measured.dofs.clear();
  const ModalUpdate free =
      modal_update(model, measured, no_prior(3), VectorXd::Zero(3));
  EXPECT_EQ(free.standard_error.minCoeff(), kNone);
  EXPECT_FALSE(free.identifiability.confounded.empty());
  EXPECT_TRUE(free.theta.allFinite());
  // With a prior the errors are at most its own.
  Prior prior = no_prior(3);
  prior.sd.setConstant(0.2);
  const ModalUpdate held =
      modal_update(model, measured, prior, VectorXd::Zero(3));
  EXPECT_LE(held.standard_error.maxCoeff(), 0.2);
  EXPECT_GT(held.standard_error.maxCoeff(), 0.1);
}

TEST(ModalUpdater, StaysWithinBounds) {
  const ScaledModel model = chain(4);
  VectorXd truth(4);
  truth << 0.5, 0.0, -0.1, 0.1;
  Prior prior = no_prior(4);
  prior.upper(0) = 0.2;
  const ModalUpdate found =
      modal_update(model, measure(model, truth, 4), prior, VectorXd::Zero(4));
  EXPECT_EQ(found.theta(0), 0.2);
  EXPECT_EQ(found.at_bound, (std::vector<bool>{true, false, false, false}));
  EXPECT_LT(found.objective, found.history.front().objective);
}

// A model that is wrong in kind, so that no theta is right: J must not rise
// wherever the fit starts, and the start itself is returned at worst.
TEST(ModalUpdater, NeverReturnsAWorseModel) {
  const ScaledModel model = chain(8);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(-0.8, 3.0);
  MeasuredModes measured = measure(model, VectorXd::Zero(8), 4, 2);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 40; ++k) {
    measured.shape = measured.shape.unaryExpr(
        [&](double u) { return u + 0.1 * normal(random); });
    VectorXd start(8);
    for (double& x : start) x = anywhere(random);
    ModalUpdateOptions options;
    options.max_iterations = k % 3 == 0 ? 2 : 60;
    const ModalUpdate found =
        modal_update(model, measured, no_prior(8), start, options);
    const ModalResidual again = modal_residual(
        measured,
        structure::eigenmodes_up_to(model.stiffness(found.theta),
                                    model.mass(found.theta),
                                    1.616 * measured.frequency_hz(3)),
        {},
        3.0);
    EXPECT_NEAR(again.misfit, found.objective, 1e-6 * found.objective);
    EXPECT_LE(found.objective, found.history.front().objective);
    EXPECT_FALSE(found.message.empty());
  }
}

// How often the true values lie within 1.96 standard errors, over 400 tests.
// @param more shapes scatter by so much more than stated
VectorXd coverage(double more) {
  const ScaledModel model = chain(6);
  VectorXd truth(6);
  truth << -0.2, 0.1, 0.3, 0.0, -0.1, 0.2;
  const MeasuredModes perfect = measure(model, truth, 4);
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  constexpr int kTests = 400;
  VectorXd inside = VectorXd::Zero(6);
  for (int k = 0; k < kTests; ++k) {
    MeasuredModes noisy = perfect;
    for (Index i = 0; i < 4; ++i) {
      noisy.frequency_hz(i) += noisy.frequency_sd(i) * normal(random);
      for (Index m = 0; m < noisy.shape.rows(); ++m) {
        noisy.shape(m, i) += more * noisy.shape_sd(m, i) * normal(random);
      }
    }
    const ModalUpdate found =
        modal_update(model, noisy, no_prior(6), VectorXd::Zero(6));
    EXPECT_TRUE(found.converged) << found.message;
    for (Index j = 0; j < 6; ++j) {
      const double off = std::abs(found.theta(j) - truth(j));
      if (off < 1.96 * found.standard_error(j)) inside(j) += 1.0 / kTests;
    }
  }
  return inside;
}

// 95 %, with 1.1 % of scatter from 400 tests; the excess is never taken for
// less than none, which makes the errors a little wide.
TEST(ModalUpdater, StandardErrorsHold) {
  const VectorXd inside = coverage(1.0);
  EXPECT_GT(inside.minCoeff(), 0.92) << inside.transpose();
  EXPECT_LT(inside.maxCoeff(), 0.99) << inside.transpose();
}

// What four shapes of six points scatter by is itself known to a fifth only: an
// interval of a normal distribution is somewhat narrow then.
TEST(ModalUpdater, StandardErrorsHoldWhereShapesScatterMoreThanStated) {
  const VectorXd inside = coverage(5.0);
  EXPECT_GT(inside.minCoeff(), 0.87) << inside.transpose();
  EXPECT_LT(inside.maxCoeff(), 0.99) << inside.transpose();
}

TEST(ModalUpdater, SaysWhenNothingPairs) {
  const ScaledModel model = chain(4);
  MeasuredModes measured = measure(model, VectorXd::Zero(4), 2);
  measured.frequency_hz *= 100.0;
  const ModalUpdate found =
      modal_update(model, measured, no_prior(4), VectorXd::Zero(4));
  EXPECT_FALSE(found.converged);
  EXPECT_NE(found.message.find("2 of 2"), std::string::npos) << found.message;
  EXPECT_EQ(found.theta.norm(), 0.0);
}

TEST(ModalUpdater, RefusesWhatItCannotUse) {
  const ScaledModel good = chain(3);
  const MeasuredModes modes = measure(good, VectorXd::Zero(3), 2);
  const VectorXd zero = VectorXd::Zero(3);
  const auto refused = [&](const ScaledModel& model,
                           const MeasuredModes& measured,
                           const Prior& prior,
                           const VectorXd& start) {
    EXPECT_THROW(static_cast<void>(modal_update(model, measured, prior, start)),
                 InputError);
  };
  ScaledModel model = good;
  model.parts[1].K = SparseMatrix(2, 2);
  refused(model, modes, no_prior(3), zero);
  model = good;
  model.parts[1].K.coeffRef(0, 1) = 7.0;
  refused(model, modes, no_prior(3), zero);
  MeasuredModes measured = modes;
  measured.frequency_sd(1) = 0.0;
  refused(good, measured, no_prior(3), zero);
  measured = modes;
  measured.dofs[1] = 3;
  refused(good, measured, no_prior(3), zero);
  measured = modes;
  measured.shape.conservativeResize(2, 2);
  refused(good, measured, no_prior(3), zero);
  refused(good, modes, no_prior(2), zero);
  refused(good, modes, no_prior(3), VectorXd::Constant(3, -0.95));
  ModalUpdateOptions options;
  options.independent = 3.0;  // three points hold two beside their scale
  EXPECT_THROW(
      static_cast<void>(modal_update(good, modes, no_prior(3), zero, options)),
      InputError);
}

}  // namespace
}  // namespace tapfit::updating
