// Shares of a face's nodes: they reproduce the place, and quadratic fields on
// quadratic faces (the definition of shape functions).
#include "updating/structure/abaqus/face_shapes.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> with_middles(std::vector<Vector3d> corners) {
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    corners.push_back(0.5 * (corners[k] + corners[(k + 1) % n]));
  }
  return corners;
}

const std::vector<Vector3d> skew{
    {0, 0, 0}, {2, 0.1, 0}, {2.3, 1.2, 0.2}, {-0.1, 1, 0}};
const std::vector<Vector3d> triangle{{0, 0, 0}, {2, 0, 1}, {0, 1, 0}};

TEST(FaceShapes, SharesGiveThePlaceBack) {
  for (const auto& nodes :
       {skew, triangle, with_middles(skew), with_middles(triangle)}) {
    const Vector3d inside = 0.5 * nodes[0] + 0.3 * nodes[1] + 0.2 * nodes[2];
    const auto on = place_on_face(nodes, inside);
    ASSERT_TRUE(on);
    Vector3d back = Vector3d::Zero();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      back += on->shares(static_cast<Eigen::Index>(k)) * nodes[k];
    }
    EXPECT_NEAR(on->shares.sum(), 1.0, 1e-12);
    // The face of four corners is not flat: its nearest point is meant.
    EXPECT_NEAR((back - inside).norm(), on->distance, 1e-12);
    EXPECT_LT(on->distance, 0.1);
  }
}

TEST(FaceShapes, QuadraticFieldIsReproduced) {
  const std::vector<Vector3d> square{
      {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const std::vector<Vector3d> flat_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto field = [](const Vector3d& p) {
    return 1.0 + p.x() - 2.0 * p.y() + p.x() * p.y() + p.x() * p.x();
  };
  for (const auto& nodes :
       {with_middles(square), with_middles(flat_triangle)}) {
    const Vector3d p(0.2, 0.3, 0.0);
    const auto on = place_on_face(nodes, p);
    ASSERT_TRUE(on);
    double sum = 0.0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      sum += on->shares(static_cast<Eigen::Index>(k)) * field(nodes[k]);
    }
    EXPECT_NEAR(sum, field(p), 1e-9);
  }
}

TEST(FaceShapes, WhatLiesBesideIsNotOnTheFace) {
  EXPECT_FALSE(place_on_face(triangle, {3, 3, 0}));
  EXPECT_FALSE(place_on_face(skew, {5, 0, 0}));
  const auto above = place_on_face({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                   {0.5, 0.5, 0.25});
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->distance, 0.25, 1e-12);
}

}  // namespace
}  // namespace tapfit::structure
