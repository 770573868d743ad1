#include "updating/diagnosis/worth.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

// Mesh and form may leave 10 %, the hits scatter by 1 %.
constexpr Floor wide{0.10, 0.01};
// There is noise alone.
constexpr Floor narrow{0.02, 0.02};

TEST(Floors, LeaveNothingToExplainAtTheNoise) {
  EXPECT_TRUE(is_explained(0.025, narrow));
  EXPECT_FALSE(is_explained(0.027, narrow));  // 1.3 times
  EXPECT_TRUE(is_explained(0.029, wide));
  EXPECT_FALSE(is_explained(0.031, wide));  // three times the noise
}

TEST(Floors, OfMeshAndFormMayHideAnEffect) {
  EXPECT_TRUE(may_hide_effect(0.12, wide));
  EXPECT_FALSE(may_hide_effect(0.14, wide));  // above: it does not hide
  EXPECT_FALSE(may_hide_effect(0.02, wide));  // all of it may be noise
  EXPECT_FALSE(may_hide_effect(0.02, narrow));
}

TEST(AnUnexplainedError, IsFarAboveFloorAndBase) {
  EXPECT_TRUE(is_unexplained(0.4, 0.1, 1.0, false));
  EXPECT_FALSE(is_unexplained(0.25, 0.1, 1.0, false));
  // With effects in the model, also above a tenth of what was left without.
  EXPECT_FALSE(is_unexplained(0.09, 0.01, 1.0, true));
  EXPECT_TRUE(is_unexplained(0.11, 0.01, 1.0, true));
  // A base worse than no answer at all lends no explanation.
  EXPECT_TRUE(is_unexplained(0.2, 0.01, 50.0, true));
}

}  // namespace
}  // namespace tapfit::updating
