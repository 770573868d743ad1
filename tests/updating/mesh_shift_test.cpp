#include "updating/mesh_shift.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tapfit::updating {
namespace {

// Two grids, modes that move one of them each; the coarser mesh has them in the
// other order, at 0.9 of the frequency, and a third one it lacks.
TEST(MeshShiftTest, ComparesTheSameModes) {
  MeshModes finer{Eigen::MatrixXd::Zero(12, 3), Eigen::Vector3d(10, 11, 30)};
  finer.rows(2, 0) = 2.0;
  finer.rows(8, 1) = -1.0;
  finer.rows(1, 2) = 1.0;
  MeshModes coarser{Eigen::MatrixXd::Zero(12, 2), Eigen::Vector2d(9.9, 9)};
  coarser.rows(8, 0) = 1.0;
  coarser.rows(2, 1) = 1.0;
  const Eigen::VectorXd shift = mesh_shift(finer, coarser);
  const double unit = 4.0 * std::numbers::pi * std::numbers::pi;
  // Rounding of a difference of squares.
  EXPECT_NEAR(shift(0), unit * (100.0 - 81.0), 1e-9);
  EXPECT_NEAR(shift(1), unit * (121.0 - 98.01), 1e-9);
  EXPECT_EQ(shift(2), 0.0);
}

TEST(MeshShiftTest, AMeshWithoutModesMovesNone) {
  const MeshModes finer{Eigen::MatrixXd::Ones(6, 1), Eigen::VectorXd::Ones(1)};
  EXPECT_EQ(mesh_shift(finer, {Eigen::MatrixXd(6, 0), {}})(0), 0.0);
}

}  // namespace
}  // namespace tapfit::updating
