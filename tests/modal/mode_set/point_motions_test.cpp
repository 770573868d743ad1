#include "modal/mode_set/point_motions.hpp"

#include <gtest/gtest.h>

namespace tapfit::modal {
namespace {

// Node 3 along +X and -Z, node 4 along +Y and about Z.
TEST(PointMotions, PutDirectionsTogether) {
  ModeSet modes;
  modes.dofs = {{3, 1, 1}, {3, 3, -1}, {4, 2, 1}, {4, 6, 1}};
  const auto motions = point_motions(modes, Eigen::Vector4d(1, 2, 3, 4));
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions.at(3), Eigen::Vector3d(1, 0, -2));
  EXPECT_EQ(motions.at(4), Eigen::Vector3d(0, 3, 0));
  EXPECT_TRUE(point_motions(modes, {}).empty());
}

// f = a . b / b . b: (1 * 2 + 1 * 0) / 4.
TEST(FactorOnto, IsTheOneOfLeastSquares) {
  EXPECT_DOUBLE_EQ(factor_onto(Eigen::Vector2d(1, 1), Eigen::Vector2d(2, 0)),
                   0.5);
  EXPECT_EQ(factor_onto(Eigen::Vector2d(1, 1), Eigen::Vector2d(0, 0)), 1.0);
  EXPECT_EQ(factor_onto(Eigen::Vector2d(1, 1), Eigen::Vector3d(1, 1, 1)), 1.0);
}

}  // namespace
}  // namespace tapfit::modal
