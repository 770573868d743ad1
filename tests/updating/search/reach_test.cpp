#include "updating/search/reach.hpp"

#include "tests/updating/support/plain_hypothesis.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

Hypothesis left(const Reach& reach, double error) {
  return reach.judged(plain_hypothesis(error).fit);
}

// 15 of the logarithm of a likelihood of N data are a factor of exp(15 / N).
TEST(Reach, EndsWhereTheEvidenceOfARoundDoes) {
  Reach few(20.0, 1e-3);
  few.take(left(few, 0.05));
  EXPECT_FALSE(few.is_hopeless(left(few, 0.10)));
  EXPECT_TRUE(few.is_hopeless(left(few, 0.11)));
  Reach many(400.0, 1e-3);
  many.take(left(many, 0.05));
  EXPECT_FALSE(many.is_hopeless(left(many, 0.0518)));
  EXPECT_TRUE(many.is_hopeless(left(many, 0.0522)));
}

// N ln(0.20 / 0.05) = 69 are to be gained, less 15.
TEST(Reach, HoldsAWayWhosePaceIsEnough) {
  Reach reach(50.0, 1e-3);
  reach.take(left(reach, 0.05));
  // 2.4 a step.
  EXPECT_TRUE(reach.holds_way(left(reach, 0.21), left(reach, 0.20), 25));
  EXPECT_FALSE(reach.holds_way(left(reach, 0.21), left(reach, 0.20), 20));
  // What does not gain is within reach or is not.
  EXPECT_TRUE(reach.holds_way(left(reach, 0.06), left(reach, 0.06), 0));
  EXPECT_FALSE(reach.holds_way(left(reach, 0.20), left(reach, 0.20), 40));
}

}  // namespace
}  // namespace tapfit::updating
