#include "modal/mode_set/synthesis.hpp"

#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

namespace tapfit::modal {
namespace {

TEST(Synthesis, IsTheModalSum) {
  test::SyntheticSystem system;
  system.frequency_hz = Eigen::Vector2d(12.0, 30.0);
  system.damping_ratio = Eigen::Vector2d(0.01, 0.03);
  system.phi = (Eigen::MatrixXd(2, 2) << 1.0, 0.7, -0.4, 1.2).finished();
  ModeSet set;
  set.dofs = {{1, 3, 1}, {2, 3, 1}};
  set.scaled = true;
  for (Eigen::Index r = 0; r < 2; ++r) {
    Mode mode;
    const double w = 2.0 * std::numbers::pi * system.frequency_hz(r);
    const double zeta = system.damping_ratio(r);
    mode.pole = {-zeta * w, w * std::sqrt(1.0 - zeta * zeta)};
    mode.shape = system.phi.col(r).cast<std::complex<double>>();
    set.modes.push_back(mode);
  }
  const Eigen::VectorXcd s = test::line_points(1.0, 50.0, 20, 0.7);
  const auto H = synthesise(set, {1, 3, 1}, {2, 3, -1}, s);
  ASSERT_TRUE(H.has_value());
  for (Eigen::Index k = 0; k < s.size(); ++k) {
    const std::complex<double> exact = -test::accelerance(system, 0, 1, s(k));
    EXPECT_LT(std::abs((*H)(k)-exact), 1e-12 * std::abs(exact));
  }
  EXPECT_FALSE(synthesise(set, {1, 3, 1}, {7, 3, 1}, s).has_value());
  set.scaled = false;
  EXPECT_FALSE(synthesise(set, {1, 3, 1}, {2, 3, 1}, s).has_value());
}

}  // namespace
}  // namespace tapfit::modal
