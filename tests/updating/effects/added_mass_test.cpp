#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::effects {
namespace {

// A steel cube of 25 g, 15 mm wide, on a post of the same length: J of the cube
// and of its offset, m a^2 / 6 + m (1.5 a)^2.
TEST(AddedMass, TurnsNoFartherOutThanABodyReaches) {
  const Effect& mass = find("added-mass");
  Location where{.node = 5};
  const double m = 0.025;
  const double a = std::cbrt(m / 7850.0);
  const double post = m * a * a * (1.0 / 6.0 + 2.25);
  EXPECT_TRUE(mass.is_plausible(where, {m}));
  where.variant = "rotary";
  EXPECT_TRUE(mass.is_plausible(where, {m, post}));
  // An inertia for which it would have to be at the end of a long arm.
  EXPECT_FALSE(mass.is_plausible(where, {m, 20.0 * post}));
  EXPECT_FALSE(mass.is_plausible(where, {0.0017, 1e-5}));
}

}  // namespace
}  // namespace tapfit::effects
