#include "modal/poles/cmif.hpp"

#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

namespace tapfit::modal {
namespace {

TEST(Cmif, HasTheFrobeniusNormOfTheMatrix) {
  std::mt19937_64 random(3);
  test::SyntheticSystem system;
  system.frequency_hz = Eigen::Vector2d(12.0, 30.0);
  system.damping_ratio = Eigen::Vector2d(0.01, 0.03);
  system.phi = test::random_shapes(5, 2, random);
  const signal::FrfSet frfs = test::roving_hammer(
      system, {0, 2}, test::line_points(5.0, 50.0, 30, 0.5), 0.0, random);
  const Eigen::MatrixXd values = cmif(frfs);
  const Eigen::VectorXd sum = summed_frf(frfs);
  ASSERT_EQ(values.rows(), 30);
  ASSERT_EQ(values.cols(), 2);
  for (Eigen::Index k = 0; k < 30; ++k) {
    EXPECT_NEAR(values.row(k).norm(), sum(k) * std::sqrt(10.0), 1e-9 * sum(k));
  }
}

}  // namespace
}  // namespace tapfit::modal
