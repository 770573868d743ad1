#include "modal/mode_set/complexity.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

namespace tapfit {
namespace {

TEST(MeanPhaseDeviation, IsTheAngleOffTheLine) {
  using std::numbers::pi;
  Eigen::VectorXcd shape(4);
  for (Eigen::Index k = 0; k < 4; ++k) {
    // Two to the left of the line and two to the right, some turned round.
    const double angle = (k % 2 == 0 ? 20.0 : -20.0) + (k > 1 ? 180.0 : 0.0);
    shape(k) = std::polar(2.0, (37.0 + angle) * pi / 180.0);
  }
  EXPECT_NEAR(modal::mean_phase_deviation(shape), 20.0, 1e-9);
  EXPECT_NEAR(modal::mean_phase_deviation(std::polar(1.0, 0.7) *
                                          Eigen::VectorXcd::Ones(3)),
              0.0,
              1e-6);
  EXPECT_EQ(modal::mean_phase_deviation(Eigen::VectorXcd::Zero(3)), 0.0);
}

TEST(RealShape, IsTheShapeWithoutItsCommonPhase) {
  const Eigen::Vector4d phi(1.0, -0.4, 0.0, 2.5);
  for (const double angle : {0.0, 0.3, 1.2, -1.5}) {
    const Eigen::VectorXd real = modal::real_shape(
        std::polar(1.0, angle) * phi.cast<std::complex<double>>());
    // Half turns are not told apart, so all four lie within a quarter.
    EXPECT_LT((real - phi).norm(), 1e-12) << angle;
  }
}

TEST(RealShape, IsNearerThanAnyOtherTurned) {
  Eigen::Vector3cd phi({1.0, 0.2}, {-0.7, 0.1}, {0.3, 0.4});
  const double kept = modal::real_shape(phi).norm();
  for (int k = 0; k < 360; ++k) {
    const std::complex<double> turn =
        std::polar(1.0, k * std::numbers::pi / 180.0);
    EXPECT_LE((turn * phi).real().norm(), kept + 1e-12) << k;
  }
}

}  // namespace
}  // namespace tapfit
