#include "modal/fit/linear_fit.hpp"

#include "acquisition/foundation/constants.hpp"
#include "modal/fit/fit_residual.hpp"
#include "modal/fit/modal_fit.hpp"
#include "modal/fit/pole_step.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

namespace tapfit::modal {
namespace {

using Eigen::Index;

/// Nine FRFs of five modes in the band and 1 % noise.
///
/// @param lines 300: few; 3000: many
WeightedFrfs noisy_curves(Index lines, double sigma) {
  std::mt19937_64 random(5);
  const test::SyntheticSystem system =
      test::random_system(5, 9, 0.005, 0.02, random);
  std::vector<std::string> warnings;
  return prepare_frfs(
      test::roving_hammer(system,
                          {2},
                          test::line_points(5.0, 100.0, lines, sigma),
                          0.01,
                          random),
      warnings);
}

/// Near the modes, two of them within a half bandwidth of each other.
Eigen::VectorXcd start_poles() {
  Eigen::VectorXcd poles(6);
  const double hz[] = {18.0, 36.0, 55.0, 55.2, 70.0, 90.0};
  for (Index r = 0; r < poles.size(); ++r) {
    poles(r) = two_pi * hz[r] * std::complex<double>(-0.01, 1.0);
  }
  return poles;
}

// Both ways solve one problem: what is left agrees to the products' accuracy,
// 1e-10 of the FRFs' power times the columns' condition.
TEST(LinearFit, ByProductsIsThatByColumns) {
  for (const double sigma : {0.0, 0.3}) {
    WeightedFrfs curves = noisy_curves(3000, sigma);
    ASSERT_FALSE(curves.sums.are_few());
    const Eigen::VectorXcd poles = start_poles();
    const LinearFit products = fit_by_products(curves, poles);
    const PoleStep of_products = pole_step(curves, poles, products);
    // The same FRFs as few lines have them.
    curves.sums.frfs.resize(2 * curves.lines(), curves.count());
    const auto& [v, u] = curves.weights;
    const Eigen::MatrixXcd y = v.asDiagonal() * curves.H * u.asDiagonal();
    curves.sums.frfs << y.real(), y.imag();
    const LinearFit columns = fit_by_columns(curves, poles);
    const PoleStep of_columns = pole_step(curves, poles, columns);
    EXPECT_NEAR(products.misfit, columns.misfit, 1e-8 * columns.misfit);
    EXPECT_LT((products.coefficients - columns.coefficients).norm(),
              1e-7 * columns.coefficients.norm());
    EXPECT_LT((of_products.normal - of_columns.normal).norm(),
              1e-7 * of_columns.normal.norm());
    EXPECT_LT((of_products.gradient - of_columns.gradient).norm(),
              1e-7 * of_columns.gradient.norm());
  }
}

// Kaufman's gradient is exact: central differences of the misfit, of an error
// of the square of the step (1e-4 half bandwidths) and the misfit's rounding.
TEST(PoleStep, GradientIsThatOfTheMisfit) {
  for (const Index lines : {300, 3000}) {
    const WeightedFrfs curves = noisy_curves(lines, 0.2);
    EXPECT_EQ(curves.sums.are_few(), lines == 300);
    const Eigen::VectorXcd poles = start_poles();
    const PoleStep step = pole_step(curves, poles, fit_linear(curves, poles));
    for (Index r = 0; r < poles.size(); ++r) {
      const double h = -1e-4 * poles(r).real();
      for (const Index part : {0, 1}) {
        const std::complex<double> d =
            part == 0 ? std::complex<double>(h, 0) : std::complex<double>(0, h);
        Eigen::VectorXcd up = poles;
        Eigen::VectorXcd down = poles;
        up(r) += d;
        down(r) -= d;
        const double slope =
            (fit_linear(curves, up).misfit - fit_linear(curves, down).misfit) /
            (2.0 * h);
        EXPECT_NEAR(-2.0 * step.gradient(2 * r + part),
                    slope,
                    1e-5 * step.gradient.cwiseAbs().maxCoeff());
      }
    }
  }
}

// The misfit of many lines is what the fitted FRFs leave.
TEST(LinearFit, MisfitIsWhatIsLeft) {
  const WeightedFrfs curves = noisy_curves(3000, 0.0);
  const ModalFit fit = fit_residues(curves, start_poles());
  EXPECT_NEAR(left_per_line(curves, fit, {{0, curves.lines()}}).sum(),
              fit.misfit,
              1e-8 * fit.misfit);
}

}  // namespace
}  // namespace tapfit::modal
