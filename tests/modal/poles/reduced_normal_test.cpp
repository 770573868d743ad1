#include "modal/poles/reduced_normal.hpp"

#include "tests/modal/support/synthetic_frfs.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

WeightedFrfs noisy_curves(Index lines, double low_hz, double noise) {
  std::mt19937_64 random(9);
  test::SyntheticSystem system;
  system.frequency_hz = Eigen::VectorXd::LinSpaced(4, 22.0, 85.0);
  system.damping_ratio = Eigen::VectorXd::Constant(4, 0.01);
  system.phi = test::random_shapes(5, 4, random);
  std::vector<std::string> warnings;
  return prepare_frfs(
      test::roving_hammer(system,
                          {0, 3},
                          test::line_points(low_hz, 100.0, lines, 0.2),
                          noise,
                          random),
      warnings);
}

// Weighted least squares with the numerators in it, solved directly: the
// denominator's coefficients must be those of the reduced equations.
TEST(ReducedNormal, HasTheSolutionOfTheFullLeastSquares) {
  WeightedFrfs curves = noisy_curves(80, 8.0, 0.05);
  // Weights that are separable as they are.
  for (Index f = 0; f < curves.count(); ++f) {
    for (Index k = 0; k < curves.lines(); ++k) {
      curves.weight(k, f) = 1.0 + 0.5 * std::sin(0.1 * double(k));
    }
    curves.weight.col(f) *= f % 4 < 2 ? 1.0 : 3.0;  // per output
  }
  const FrfMatrix matrix = arrange_frfs(curves);
  ASSERT_EQ(matrix.references, 2);
  constexpr Index n = 6;
  const Index refs = 2;
  const auto outputs = static_cast<Index>(matrix.rows.size());
  const BandCircle circle = lay_on_circle(curves, n);
  const Eigen::MatrixXd M = reduced_normal(curves, matrix, circle, n);

  // Unknowns of column c of A: numerators of every output, then A.
  const Index unknowns = outputs * (n + 1) + (n + 1) * refs;
  Eigen::MatrixXcd J =
      Eigen::MatrixXcd::Zero(outputs * curves.lines(), unknowns);
  for (Index o = 0; o < outputs; ++o) {
    for (Index k = 0; k < curves.lines(); ++k) {
      const double theta = (curves.s(k).imag() - circle.omega_0) * circle.dt;
      const auto& row = matrix.rows[static_cast<std::size_t>(o)];
      for (Index r = 0; r <= n; ++r) {
        const Complex power =
            curves.weight(k, row[0]) * std::polar(1.0, -theta * double(r));
        const Index at = o * curves.lines() + k;
        J(at, o * (n + 1) + r) = power;
        for (Index i = 0; i < refs; ++i) {
          J(at, outputs * (n + 1) + r * refs + i) =
              -power * curves.H(k, row[static_cast<std::size_t>(i)]);
        }
      }
    }
  }
  const Eigen::MatrixXd N = (J.adjoint() * J).real();
  const Index b = outputs * (n + 1);
  const Eigen::MatrixXd expected =
      N.bottomRightCorner(unknowns - b, unknowns - b) -
      N.bottomLeftCorner(unknowns - b, b) *
          N.topLeftCorner(b, b).ldlt().solve(N.topRightCorner(b, unknowns - b));
  ASSERT_EQ(M.rows(), expected.rows());
  // The weights come back as geometric means: one factor is common.
  const double factor = M.trace() / expected.trace();
  EXPECT_LT((M - factor * expected).norm(), 1e-8 * M.norm());
}

}  // namespace
}  // namespace tapfit::modal
