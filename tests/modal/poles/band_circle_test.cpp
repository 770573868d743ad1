#include "modal/poles/band_circle.hpp"

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

TEST(BandCircle, LagSumsAreTheirDefinition) {
  for (const double low : {0.5, 5.0, 61.0}) {
    const WeightedFrfs curves = noisy_curves(97, low, 0.05);
    const BandCircle circle = lay_on_circle(curves, 20);
    const Eigen::MatrixXd sums = lag_sums(circle, curves.H, 20);
    ASSERT_EQ(sums.rows(), 41);
    for (const Index l : {-20, -3, 0, 1, 20}) {
      double expected = 0.0;
      for (Index k = 0; k < curves.lines(); ++k) {
        const double theta = (curves.s(k).imag() - circle.omega_0) * circle.dt;
        expected +=
            (curves.H(k, 2) * std::polar(1.0, -theta * double(l))).real();
      }
      // Rounding of a sum of 97 values.
      EXPECT_NEAR(
          sums(20 + l, 2), expected, 1e-12 * curves.H.col(2).cwiseAbs().sum());
    }
  }
}

TEST(BandCircle, KeepsTheBandOnTheUpperHalf) {
  for (const double low : {0.5, 5.0, 61.0}) {
    for (const Index largest : {10, 200}) {
      const WeightedFrfs curves = noisy_curves(900, low, 0.0);
      const BandCircle circle = lay_on_circle(curves, largest);
      const double last = circle.first + curves.spacing * circle.dt * 899.0;
      EXPECT_GE(circle.first, 0.0);
      EXPECT_LT(last, 3.14159);
    }
  }
}

}  // namespace
}  // namespace tapfit::modal
