#include "updating/minimiser/bounded_step.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Karush, Kuhn and Tucker: within the bounds; no slope inside, and only one
// that leads outwards at a bound. Sufficient, the quadratic being convex.
TEST(BoundedStep, IsTheLeast) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  int at_bounds = 0;
  for (int k = 0; k < 300; ++k) {
    const Index n = 1 + k % 12;
    const MatrixXd B =
        MatrixXd::NullaryExpr(n, n, [&] { return normal(random); });
    const MatrixXd A = B.transpose() * B + 1e-4 * MatrixXd::Identity(n, n);
    const VectorXd g = VectorXd::NullaryExpr(n, [&] { return normal(random); });
    // Some stand at a bound to begin with, some cannot move at all.
    const auto room = [&] {
      const double u = uniform(random);
      return u < 0.2 ? 0.0 : 0.6 * u;
    };
    const VectorXd lower = -VectorXd::NullaryExpr(n, room);
    const VectorXd upper = VectorXd::NullaryExpr(n, room);
    const VectorXd d = bounded_step(A, g, lower, upper);
    const VectorXd slope = A * d + g;
    for (Index j = 0; j < n; ++j) {
      ASSERT_GE(d(j), lower(j));
      ASSERT_LE(d(j), upper(j));
      const double rounding = 1e-10 * A.norm();
      if (d(j) > lower(j)) {
        EXPECT_LT(slope(j), rounding) << k;
      }
      if (d(j) < upper(j)) {
        EXPECT_GT(slope(j), -rounding) << k;
      }
      at_bounds += d(j) == lower(j) || d(j) == upper(j) ? 1 : 0;
    }
  }
  EXPECT_GT(at_bounds, 300);
}

TEST(BoundedStep, IsNewtonsWithoutBounds) {
  MatrixXd A(2, 2);
  A << 2.0, 0.5, 0.5, 1.0;
  const VectorXd g = VectorXd::Constant(2, 1.0);
  const VectorXd far =
      VectorXd::Constant(2, std::numeric_limits<double>::infinity());
  EXPECT_LT((A * bounded_step(A, g, -far, far) + g).norm(), 1e-14);
}

}  // namespace
}  // namespace tapfit::updating
