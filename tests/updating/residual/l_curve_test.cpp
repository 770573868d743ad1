#include "updating/residual/l_curve.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A smoothing kernel, whose singular values fall by many decades, and a smooth
// truth seen through it with noise (after C. B. Shaw's image restoration).
struct IllPosed {
  MatrixXd S;
  VectorXd truth;
  VectorXd d;

  explicit IllPosed(double noise) : S(40, 20), truth(20), d(40) {
    for (Index i = 0; i < 40; ++i) {
      for (Index j = 0; j < 20; ++j) {
        const double x = static_cast<double>(i) / 39.0;
        const double y = static_cast<double>(j) / 19.0;
        S(i, j) = std::exp(-20.0 * (x - y) * (x - y));
      }
    }
    for (Index j = 0; j < 20; ++j) {
      truth(j) = std::sin(M_PI * static_cast<double>(j) / 19.0);
    }
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    d = S * truth;
    for (double& value : d) value += noise * normal(random);
  }
};

TEST(LCurveTest, SolvesTheNormalEquations) {
  const IllPosed problem(0.01);
  const TikhonovSystem system(problem.S, problem.d);
  const double lambda = 0.1;
  const MatrixXd A = problem.S.transpose() * problem.S +
                     lambda * lambda * MatrixXd::Identity(20, 20);
  const VectorXd x = A.ldlt().solve(problem.S.transpose() * problem.d);
  // The normal equations square a condition of 1e2.
  EXPECT_LT((system.solve(lambda) - x).norm(), 1e-10 * x.norm());
}

TEST(LCurveTest, NormsAndCurvatureAreThoseOfTheSolutions) {
  const IllPosed problem(0.01);
  const TikhonovSystem system(problem.S, problem.d);
  const LCurve curve = system.l_curve(400);
  for (Index k = 1; k + 1 < curve.lambda.size(); k += 20) {
    const VectorXd x = system.solve(curve.lambda(k));
    // Directions of rounding size are left out by one, damped by the other.
    EXPECT_NEAR(curve.solution_norm(k), x.norm(), 1e-6 * x.norm());
    EXPECT_NEAR(curve.residual_norm(k),
                (problem.S * x - problem.d).norm(),
                1e-6 * problem.d.norm());
  }
  // Curvature by differences of the points of the curve.
  for (Index k = 150; k < 350; k += 10) {
    const auto at = [&](Index i) {
      return Eigen::Vector2d(std::log(curve.residual_norm(i)),
                             std::log(curve.solution_norm(i)));
    };
    const Eigen::Vector2d d1 = 0.5 * (at(k + 1) - at(k - 1));
    const Eigen::Vector2d d2 = at(k + 1) - 2.0 * at(k) + at(k - 1);
    const double numeric =
        (d1.x() * d2.y() - d1.y() * d2.x()) / std::pow(d1.norm(), 3);
    // Differences over a step of some 10 %: a few per cent of the largest.
    EXPECT_NEAR(curve.curvature(k), numeric, 0.05 * curve.curvature.maxCoeff());
  }
}

TEST(LCurveTest, CornerIsNearTheBestLambda) {
  const IllPosed problem(0.01);
  const TikhonovSystem system(problem.S, problem.d);
  const LCurve curve = system.l_curve();
  double best = 1e300;
  for (const double lambda : curve.lambda) {
    best = std::min(best, (system.solve(lambda) - problem.truth).norm());
  }
  const double at_corner =
      (system.solve(curve.lambda(curve.corner)) - problem.truth).norm();
  // The corner is a rule of thumb: within a factor of 5 of what only the truth
  // could tell, and far from the unregularised solution.
  EXPECT_LT(at_corner, 5.0 * best);
  EXPECT_LT(at_corner, 0.01 * (system.solve(0.0) - problem.truth).norm());
}

}  // namespace
}  // namespace tapfit::updating
