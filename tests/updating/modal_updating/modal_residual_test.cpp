#include "updating/modal_updating/modal_residual.hpp"

#include "tests/updating/support/spring_chain.hpp"
#include "updating/modal_updating/shape_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using support::chain;
using support::measure;
using support::modes_of;

// Against the definition: no a and no e nearby is better.
TEST(ShapeFit, IsTheLeast) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  int exceeding = 0;
  for (int k = 0; k < 50; ++k) {
    const auto noise = [&] { return normal(random); };
    const MatrixXd phi = MatrixXd::NullaryExpr(9, 3, noise);
    const MatrixXd sd =
        (0.3 * MatrixXd::NullaryExpr(9, 3, noise)).array().exp() * 0.1;
    const double scatter = k % 2 == 0 ? 0.05 : 0.4;
    const MatrixXd u =
        -2.0 * phi + scatter * MatrixXd::NullaryExpr(9, 3, noise);
    const ShapeFit fit = fit_shapes(u, phi, sd);
    const Eigen::RowVectorXd size2 = u.cwiseAbs2().colwise().mean();
    const double e = fit.excess(0) / std::sqrt(size2(0));
    exceeding += e > 0.0 ? 1 : 0;
    const auto misfit = [&](const VectorXd& a, double of_e) {
      double sum = 0.0;
      for (Index j = 0; j < 3; ++j) {
        for (Index i = 0; i < 9; ++i) {
          const double v = of_e * of_e * size2(j);
          const double variance = sd(i, j) * sd(i, j) + v;
          sum += std::pow(u(i, j) - a(j) * phi(i, j), 2) / variance +
                 std::log(variance / (sd(i, j) * sd(i, j)));
        }
      }
      return sum;
    };
    EXPECT_NEAR(misfit(fit.factor, e), fit.misfit, 1e-9 * fit.misfit);
    for (Index j = 0; j < 3; ++j) {
      for (const double off : {-1e-3, 1e-3}) {
        EXPECT_GE(misfit(fit.factor + off * VectorXd::Unit(3, j), e),
                  fit.misfit - 1e-9);
      }
    }
    for (const double other : {0.0, 0.03, 0.1, 0.99 * e, 1.01 * e, 0.5}) {
      EXPECT_GE(misfit(fit.factor, other), fit.misfit - 1e-9);
    }
  }
  EXPECT_GE(exceeding, 25);
  EXPECT_LT(exceeding, 50);
}

// @param scatter of the shapes, stated; the model misses by some 0.1
void compare_residuals(double scatter) {
  const ScaledModel model = chain(12, 3);
  const VectorXd truth = VectorXd::LinSpaced(15, -0.2, 0.3);
  MeasuredModes measured = measure(model, truth, 4, 2);
  measured.shape_sd *= scatter / 0.02;
  const auto residual = [&](const VectorXd& theta) {
    return modal_residual(measured, modes_of(model, theta, 6), {}, 5.0);
  };
  const VectorXd theta = VectorXd::Constant(15, 0.03);
  const ModalResidual at = residual(theta);
  ASSERT_EQ(at.pairs.size(), 4U);
  const bool exceeds = at.excess.maxCoeff() > 0.0;
  EXPECT_EQ(exceeds, scatter < 0.1);
  const MatrixXd J =
      modal_jacobian(model, theta, measured, modes_of(model, theta, 6), at);
  constexpr double h = 1e-5;
  for (Index j = 0; j < 15; ++j) {
    const VectorXd e = h * VectorXd::Unit(15, j);
    const ModalResidual more = residual(theta + e);
    const ModalResidual less = residual(theta - e);
    const VectorXd numeric = (more.r - less.r) / (2.0 * h);
    // With an excess r changes by its change too, J does not.
    if (!exceeds) {
      EXPECT_LT((J.col(j) - numeric).norm(), 1e-6 * J.norm()) << j;
    }
    EXPECT_NEAR((more.misfit - less.misfit) / (2.0 * h),
                2.0 * at.weight.cwiseProduct(at.r).dot(J.col(j)),
                1e-6 * at.misfit);
  }
}

TEST(ModalResidual, JacobianAgreesWithDifferences) { compare_residuals(0.5); }

TEST(ModalResidual, SlopeHoldsWhereShapesMissByMoreThanTheyScatter) {
  compare_residuals(0.002);
}

TEST(ModalResidual, CountsAModeWithoutPartnerAsTheWorst) {
  const ScaledModel model = chain(6);
  const MeasuredModes measured = measure(model, VectorXd::Zero(6), 3);
  const VectorXd soft = VectorXd::Constant(6, -0.5);
  const ModalResidual some =
      modal_residual(measured, modes_of(model, soft, 3), {1.1, 1.6, 1.0}, 5.0);
  EXPECT_TRUE(some.pairs.empty());  // no MAC is as large as 1.1
  const ModalResidual all =
      modal_residual(measured, modes_of(model, soft, 3), {}, 5.0);
  EXPECT_EQ(all.pairs.size(), 3U);
  EXPECT_GT(some.misfit, all.misfit);
  EXPECT_EQ(some.frequency_hz.norm(), 0.0);
}

}  // namespace
}  // namespace tapfit::updating
