#include "updating/modal_updating/mode_sensitivity.hpp"

#include "tests/updating/support/spring_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using support::chain;
using support::modes_of;

TEST(ModeSensitivity, IsThatOfTheClosedForm) {
  // All springs alike: lambda is proportional to their stiffness, and a uniform
  // change leaves the shapes.
  const ScaledModel model = chain(40);
  const VectorXd theta = VectorXd::Zero(40);
  const ModeSensitivity sensitivity(model, theta, modes_of(model, theta, 40));
  for (const Index mode : {0, 1, 7}) {
    const double lambda =
        4.0 * 5000.0 / 2.0 *
        std::pow(std::sin((2.0 * static_cast<double>(mode) + 1.0) *
                          std::numbers::pi / (2.0 * (2.0 * 40.0 + 1.0))),
                 2);
    const ModeDerivative d = sensitivity.of(mode);
    EXPECT_NEAR(d.lambda.sum(), lambda, 1e-9 * lambda);
    EXPECT_LT(d.phi.rowwise().sum().norm(), 1e-9 * d.phi.norm());
  }
}

// Central differences of the modes themselves, at a theta that is not special.
// More than 200 degrees of freedom and few modes: what the modes above add is
// most of a derivative then.
void compare_with_differences(const ScaledModel& model, Index count) {
  const auto parts = static_cast<Index>(model.parts.size());
  VectorXd theta(parts);
  for (Index j = 0; j < parts; ++j) {
    theta(j) = 0.2 * std::sin(1.0 + 2.3 * static_cast<double>(j));
  }
  const structure::Eigenmodes modes = modes_of(model, theta, count);
  const ModeSensitivity sensitivity(model, theta, modes);
  constexpr double h = 1e-5;
  for (const Index j : {Index{0}, Index{3}, parts - 1}) {
    const VectorXd e = VectorXd::Unit(parts, j);
    structure::Eigenmodes more = modes_of(model, theta + h * e, count);
    structure::Eigenmodes less = modes_of(model, theta - h * e, count);
    for (Index i = 0; i + 1 < count; ++i) {
      const ModeDerivative d = sensitivity.of(i);
      const auto oriented = [&](const structure::Eigenmodes& found) {
        const VectorXd phi = found.phi.col(i);
        return VectorXd(phi.dot(modes.phi.col(i)) < 0.0 ? -phi : phi);
      };
      const VectorXd numeric = (oriented(more) - oriented(less)) / (2.0 * h);
      // Differences lose 1e-11 / h to rounding and h^2 to curvature.
      EXPECT_LT((d.phi.col(j) - numeric).norm(), 2e-6 * modes.phi.col(i).norm())
          << "mode " << i << " part " << j;
      const double two_pi = 2.0 * std::numbers::pi;
      const double slope = (std::pow(two_pi * more.frequency_hz(i), 2) -
                            std::pow(two_pi * less.frequency_hz(i), 2)) /
                           (2.0 * h);
      EXPECT_NEAR(d.lambda(j),
                  slope,
                  2e-6 * std::pow(two_pi * modes.frequency_hz(i), 2));
    }
  }
}

TEST(ModeSensitivity, AgreesWithDifferences) {
  compare_with_differences(chain(12, 12), 12);
}

TEST(ModeSensitivity, MissesNothingOfModesThatAreNotKnown) {
  compare_with_differences(chain(300, 4), 5);
}

}  // namespace
}  // namespace tapfit::updating
