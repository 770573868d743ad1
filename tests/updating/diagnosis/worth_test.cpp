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

TEST(Floors, AskMoreOfAnEffectBelowThem) {
  EXPECT_DOUBLE_EQ(share_to_reach(0.12, wide), 1.0 / 3.0);
  EXPECT_GT(share_to_reach(0.14, wide), 0.5);
}

TEST(Floors, MakeAnEffectSuperfluousThatOnlyTheyNeed) {
  const double strong = 100.0;  // log evidence
  EXPECT_TRUE(is_superfluous(1.0, 0.01, 0.5, wide)) << "no evidence";
  EXPECT_TRUE(is_superfluous(strong, 0.08, 0.12, wide));
  EXPECT_FALSE(is_superfluous(strong, 0.02, 0.12, wide)) << "far below";
  EXPECT_FALSE(is_superfluous(strong, 0.08, 0.5, wide)) << "far above";
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
