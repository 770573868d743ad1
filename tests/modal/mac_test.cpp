#include "modal/mac.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

namespace tapfit::modal {
namespace {

Eigen::MatrixXcd random_shapes(Eigen::Index n, Eigen::Index m, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXcd::NullaryExpr(n, m, [&] {
    return std::complex<double>(normal(random), normal(random));
  });
}

TEST(Mac, IsOneForTheSameShapeInAnyScaleAndPhase) {
  const Eigen::MatrixXcd U = random_shapes(7, 3, 1);
  const Eigen::MatrixXcd V = std::complex<double>(-0.3, 2.0) * U;
  const Eigen::MatrixXd result = mac(U, V);
  // Rounding of a sum of seven products.
  EXPECT_LT((result.diagonal().array() - 1.0).abs().maxCoeff(), 1e-14);
  EXPECT_GE(result.minCoeff(), 0.0);
  EXPECT_LE(result.maxCoeff(), 1.0);
}

TEST(Mac, MatchesItsDefinition) {
  const Eigen::MatrixXcd U = random_shapes(5, 2, 2);
  const Eigen::MatrixXcd V = random_shapes(5, 4, 3);
  const Eigen::MatrixXd result = mac(U, V);
  ASSERT_EQ(result.rows(), 2);
  ASSERT_EQ(result.cols(), 4);
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      std::complex<double> inner = 0.0;
      double uu = 0.0;
      double vv = 0.0;
      for (Eigen::Index k = 0; k < 5; ++k) {
        inner += std::conj(U(k, i)) * V(k, j);
        uu += std::norm(U(k, i));
        vv += std::norm(V(k, j));
      }
      EXPECT_NEAR(result(i, j), std::norm(inner) / uu / vv, 1e-14);
    }
  }
}

TEST(Mac, IsZeroForOrthogonalAndForZeroShapes) {
  Eigen::MatrixXcd U = Eigen::MatrixXcd::Zero(3, 2);
  U(0, 0) = 1.0;
  Eigen::MatrixXcd V = Eigen::MatrixXcd::Zero(3, 1);
  V(1, 0) = 2.0;
  EXPECT_EQ(mac(U, V), Eigen::MatrixXd::Zero(2, 1));
}

TEST(Comac, IsOneWhereShapesAgreeInScaleAndSign) {
  const Eigen::MatrixXcd U = random_shapes(6, 4, 5);
  Eigen::MatrixXcd V = -2.0 * U;
  // A point whose motion is swapped between modes agrees less.
  V.row(2) = U.row(2).reverse();
  const Eigen::VectorXd result = comac(U, V);
  for (const Eigen::Index k : {0, 1, 3, 4, 5}) {
    EXPECT_NEAR(result(k), 1.0, 1e-14);
  }
  EXPECT_LT(result(2), 0.99);
}

}  // namespace
}  // namespace tapfit::modal
