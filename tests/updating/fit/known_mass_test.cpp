#include "updating/fit/known_mass.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A deck of 4 kg: 3 kg go with the first property, 2 of these with the second
// as well; a mass is the last parameter but one.
MassLaw law() {
  return {4.0, {{{1, 0}, 3.0}, {{0, 1}, 2.0}, {{1, 1}, 2.0}}, 2, {3}};
}

VectorXd state() {
  VectorXd theta(5);
  theta << std::log(1.1), std::log(0.8), std::log(0.01), std::log(0.25), 7.0;
  return theta;
}

TEST(KnownMass, IsThatOfTheDeckAsItsPropertiesAreWithMassesOnIt) {
  const double kg = 1.0 + 1.1 * (1.0 + 0.8 * 2.0) + 0.25;
  const Residuals at = law().residual({5.0, 0.03}, state());
  ASSERT_EQ(at.r.size(), 1);
  EXPECT_NEAR(at.r(0), std::log(kg / 5.0) / 0.03, 1e-12);
}

TEST(KnownMass, HasTheSlopesOfDifferences) {
  const KnownMass known{5.0, 0.03};
  const Residuals at = law().residual(known, state());
  for (Index k = 0; k < 5; ++k) {
    constexpr double step = 1e-6;
    VectorXd up = state();
    VectorXd down = state();
    up(k) += step;
    down(k) -= step;
    const double slope =
        (law().residual(known, up).r(0) - law().residual(known, down).r(0)) /
        (2.0 * step);
    EXPECT_NEAR(at.J(0, k), slope, 1e-6) << k;
  }
}

TEST(KnownMass, IsKnownNoBetterThanDecksHoldAllOfIt) {
  EXPECT_NEAR(known_mass({2.0, {}, 1.0}).sd, std::hypot(0.01, 0.025), 1e-12);
  EXPECT_EQ(known_mass({2.0, {}, 1.0}).kg, 2.0);
}

}  // namespace
}  // namespace tapfit::updating
