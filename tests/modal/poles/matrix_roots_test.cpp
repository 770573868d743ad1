#include "modal/poles/matrix_roots.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <numbers>
#include <random>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Largest distance from a root expected to the nearest one found.
double farthest(const Eigen::VectorXcd& expected,
                const Eigen::VectorXcd& found) {
  double worst = 0.0;
  for (const Complex& z : expected) {
    worst = std::max(worst, (found.array() - z).abs().minCoeff());
  }
  return worst;
}

/// Coefficients of the scalar polynomial with these roots, without the highest.
Eigen::MatrixXd with_roots(const Eigen::VectorXcd& roots) {
  Eigen::VectorXcd c = Eigen::VectorXcd::Zero(roots.size() + 1);
  c(0) = 1.0;  // rising powers, degree 0
  for (Index d = 0; d < roots.size(); ++d) {
    for (Index r = d + 1; r >= 0; --r) {
      c(r) = (r > 0 ? c(r - 1) : Complex(0.0)) - roots(d) * c(r);
    }
  }
  return c.head(roots.size()).real().transpose();
}

TEST(MatrixRoots, AreThoseOfUnity) {
  constexpr Index n = 150;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(1, n);
  A(0, 0) = -1.0;
  Eigen::VectorXcd expected(n);
  for (Index k = 0; k < n; ++k) {
    expected(k) = std::polar(1.0, 2.0 * std::numbers::pi * double(k) / n);
  }
  const Eigen::VectorXcd found = matrix_roots(A, {});
  ASSERT_EQ(found.size(), n);
  // Roots of unity are perfectly conditioned.
  EXPECT_LT(farthest(expected, found), 1e-13);
  EXPECT_LT(farthest(found, expected), 1e-13);
}

TEST(MatrixRoots, FindsPairsOutsideAmongManyInside) {
  Eigen::VectorXcd expected(24);
  for (Index k = 0; k < 12; ++k) {
    const double radius = k < 3 ? 1.01 : 0.85;
    expected(2 * k) = std::polar(radius, 0.13 + 0.25 * double(k));
    expected(2 * k + 1) = std::conj(expected(2 * k));
  }
  const Eigen::VectorXcd found = matrix_roots(with_roots(expected), {});
  // Coefficients were rounded at 1e-16 of values up to 1e2.
  EXPECT_LT(farthest(expected, found), 1e-10);
}

TEST(MatrixRoots, AreTheEigenvaluesOfTheCompanionMatrix) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (const Index k : {1, 2, 3, 4}) {
    const Index size = 12 * k;
    const Eigen::MatrixXd A = 0.3 * Eigen::MatrixXd::NullaryExpr(k, size, [&] {
                                return normal(random);
                              });
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(size, size);
    C.topRightCorner(size - k, size - k).setIdentity();
    C.bottomRows(k) = -A;
    const Eigen::VectorXcd expected = C.eigenvalues();
    const Eigen::VectorXcd found = matrix_roots(A, {});
    ASSERT_EQ(found.size(), size);
    SCOPED_TRACE(k);
    EXPECT_LT(farthest(expected, found), 1e-9);
    EXPECT_LT(farthest(found, expected), 1e-9);
    for (const Complex& z : found) {
      Eigen::MatrixXcd value =
          Eigen::MatrixXcd::Identity(k, k) * std::pow(z, 12);
      for (Index r = 0; r < 12; ++r) {
        value += A.middleCols(r * k, k) * std::pow(z, r);
      }
      const Eigen::VectorXcd v = left_null_vector(A, z);
      const double scale = std::max(1.0, std::pow(std::abs(z), 12));
      EXPECT_LT((value.transpose() * v).norm(), 1e-9 * scale);
    }
  }
}

TEST(MatrixRoots, FindsMultipleRootsByTheOtherWay) {
  Eigen::VectorXcd expected(8);
  expected << 0.5, 0.5, 0.5, 0.5, Complex(0.2, 0.9), Complex(0.2, -0.9),
      Complex(0.2, 0.9), Complex(0.2, -0.9);
  const Eigen::VectorXcd found = matrix_roots(with_roots(expected), {});
  ASSERT_EQ(found.size(), 8);
  // A root of multiplicity m is known to the m-th root of the rounding.
  EXPECT_LT(farthest(expected, found), 1e-3);
}

TEST(MatrixRoots, ComeOutTheSameFromAnyStart) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd A =
      0.2 * Eigen::MatrixXd::NullaryExpr(2, 60, [&] { return normal(random); });
  const Eigen::VectorXcd cold = matrix_roots(A, {});
  const Eigen::VectorXcd warm =
      matrix_roots(A, cold.head(50) * Complex(1.01, 0.003));
  EXPECT_LT(farthest(cold, warm), 1e-10);
}

}  // namespace
}  // namespace tapfit::modal
