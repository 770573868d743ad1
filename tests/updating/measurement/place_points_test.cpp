// Points of a test's own on the model: their FRFs against the grids' own.
#include "updating/measurement/place_points.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/places/between_grids.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace tapfit::updating {
namespace {

using acquisition::TestPoint;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

TestPoint point_at(const Vector3d& at,
                   const Matrix3d& axes = Matrix3d::Identity()) {
  TestPoint point;
  point.label = 5;
  point.at = at;
  point.axes = axes;
  point.place = "test.json: runs[0].sensors[0].point";
  return point;
}

TestPoint point_at_grid(int node, const Matrix3d& axes) {
  TestPoint point = point_at(Vector3d::Zero(), axes);
  point.at.reset();
  point.node = node;
  return point;
}

const Matrix3d skew =
    Eigen::AngleAxisd(0.7, Vector3d(0.3, -0.5, 1.0).normalized())
        .toRotationMatrix();

class PlacePoints : public ::testing::Test {
 protected:
  structure::Deck placed(const std::vector<TestPoint>& points) {
    acquisition::TestBundle bundle = bundle_;
    bundle.points = points;
    std::set<int> used;
    for (const TestPoint& point : points) used.insert(point.label);
    structure::Deck deck = deck_;
    place_points(bundle, used, deck);
    return deck;
  }
  structure::Deck placed(const TestPoint& point) {
    return placed(std::vector{point});
  }

  // Receptances from a blow on grid 28 along Z to degrees of freedom, on two
  // real s, of the whole model: (K + s^2 M)^-1.
  static std::vector<VectorXd> frfs(const structure::Deck& deck,
                                    const std::vector<Dof>& responses) {
    const structure::System system = structure::assemble(deck);
    const Eigen::Index n = system.dofs();
    const MatrixXd T =
        system.T.size() > 0 ? MatrixXd(system.T) : MatrixXd::Identity(n, n);
    const std::vector<int> free = system.free_dofs();
    const MatrixXd V = T(Eigen::all, free);
    const auto row = [&](const Dof& dof) -> Eigen::RowVectorXd {
      const auto grid = static_cast<Eigen::Index>(deck.grid_index(dof.node));
      return dof.sign * V.row(6 * grid + dof.component - 1);
    };
    std::vector<VectorXd> H(responses.size(), VectorXd(2));
    const std::array<double, 2> lines{100.0, 1000.0};
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const structure::SparseMatrix Z =
          system.K + lines.at(l) * lines.at(l) * system.M;
      const MatrixXd reduced = V.transpose() * (Z * V);
      const VectorXd x = reduced.ldlt().solve(row({28, 3, 1}).transpose());
      for (std::size_t k = 0; k < responses.size(); ++k) {
        H[k](static_cast<Eigen::Index>(l)) = row(responses[k]) * x;
      }
    }
    return H;
  }

  void refuses(const TestPoint& point, const std::string& what) {
    try {
      (void)placed(point);
      ADD_FAILURE() << "accepted, expected: " << what;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), point.place) << error.what();
      EXPECT_NE(error.fault().find(what), std::string::npos) << error.what();
      EXPECT_GT(error.remedy().size(), 10U);
    }
  }

  acquisition::TestBundle bundle_ = support::plate_bundle();
  structure::Deck deck_ = support::plate_deck(true);
};

TEST_F(PlacePoints, ASkewSensorFeelsTheSumOfTheAxes) {
  const auto H = frfs(placed(point_at_grid(42, skew)),
                      {{-5, 1, 1},
                       {-5, 2, -1},
                       {-5, 3, 1},
                       {42, 1, 1},
                       {42, 2, 1},
                       {42, 3, 1}});
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double sign = k == 1 ? -1.0 : 1.0;
    const VectorXd sum =
        sign * (skew(0, k) * H[3] + skew(1, k) * H[4] + skew(2, k) * H[5]);
    EXPECT_LT((H[static_cast<std::size_t>(k)] - sum).norm(),
              1e-9 * H[5].norm());
  }
}

// The rest of the model is as it was.
TEST_F(PlacePoints, APointChangesNothingElse) {
  const auto with = frfs(placed(point_at({0.1, 0.07, 0.0})), {{42, 3, 1}});
  const auto without = frfs(deck_, {{42, 3, 1}});
  EXPECT_LT((with[0] - without[0]).norm(), 1e-9 * without[0].norm());
}

TEST_F(PlacePoints, BetweenGridsTheShapeFunctionsTell) {
  const Vector3d at(0.1, 0.07, 0.0);
  const structure::Deck deck = placed(point_at(at));
  Location where;
  where.node = 26;  // a corner of that shell
  where.at = {at.x(), at.y(), at.z()};
  const std::vector<MotionShare> shares = motion_between(deck_, where, 3);
  ASSERT_FALSE(shares.empty());
  std::vector<Dof> dofs{{-5, 3, 1}};
  for (const MotionShare& share : shares) {
    dofs.push_back({share.node, share.component, 1});
  }
  const auto H = frfs(deck, dofs);
  VectorXd sum = VectorXd::Zero(H[0].size());
  for (std::size_t k = 0; k < shares.size(); ++k) {
    sum += shares[k].weight * H[k + 1];
  }
  EXPECT_GT(H[0].norm(), 0.0);
  EXPECT_LT((H[0] - sum).norm(), 1e-9 * H[0].norm());
}

// u_x = u_x(0) + h theta_y, u_y = u_y(0) - h theta_x.
TEST_F(PlacePoints, HeightAddsTheTurnOfTheSurface) {
  TestPoint point = point_at_grid(42, Matrix3d::Identity());
  point.height_m = 0.008;
  const structure::Deck deck = placed(point);
  EXPECT_NEAR(deck.grids.front().position.z(), 0.008, 1e-15);
  const auto H = frfs(deck,
                      {{-5, 1, 1},
                       {-5, 2, 1},
                       {-5, 3, 1},
                       {42, 1, 1},
                       {42, 2, 1},
                       {42, 3, 1},
                       {42, 4, 1},
                       {42, 5, 1}});
  EXPECT_LT((H[0] - H[3] - 0.008 * H[7]).norm(), 1e-9 * H[0].norm());
  EXPECT_LT((H[1] - H[4] + 0.008 * H[6]).norm(), 1e-9 * H[1].norm());
  EXPECT_LT((H[2] - H[5]).norm(), 1e-9 * H[2].norm());
  // In bending it is nearly all that moves along the plate.
  EXPECT_GT((0.008 * H[7]).norm(), 10.0 * H[3].norm());
}

// Grids with axes of their own (CD).
TEST_F(PlacePoints, TurnedGridsAreFollowedInBasicAxes) {
  const auto plain =
      frfs(placed(point_at({0.1, 0.07, 0.01}, skew)), {{-5, 3, 1}});
  for (structure::Grid& grid : deck_.grids) {
    if (grid.position.x() > 0.0) grid.axes = skew;
  }
  const auto turned =
      frfs(placed(point_at({0.1, 0.07, 0.01}, skew)), {{-5, 3, 1}});
  EXPECT_LT((plain[0] - turned[0]).norm(), 1e-6 * plain[0].norm());
}

TEST_F(PlacePoints, AxesOfTheDecksSystems) {
  CoordinateSystem cylinder;
  cylinder.kind = CoordinateKind::Cylindrical;
  cylinder.origin = {0.1, 0.07, 0.0};
  deck_.systems[3] = cylinder;
  TestPoint point = point_at({0.1, 0.1, 0.0});
  point.system = 3;
  const structure::Deck deck = placed(point);
  // r is +Y there, theta -X.
  EXPECT_TRUE(
      direction_of(deck, {-5, 1, 1}).isApprox(Vector3d::UnitY(), 1e-12));
  EXPECT_TRUE(
      direction_of(deck, {-5, 2, 1}).isApprox(-Vector3d::UnitX(), 1e-12));
  point.system = 4;
  refuses(point, "no coordinate system 4");
}

TEST_F(PlacePoints, SaysWhatCarriesAPointAndHowFarItIs) {
  const structure::Deck deck = placed(point_at({0.1, 0.07, 0.004}));
  ASSERT_EQ(deck.measuring.size(), 1U);
  EXPECT_EQ(deck.measuring[0].grid, -5);
  EXPECT_EQ(deck.measuring[0].on, "shell 24");
  EXPECT_NEAR(deck.measuring[0].off, 0.004, 1e-12);
  EXPECT_EQ(deck.measuring[0].nearest, 26);
  EXPECT_EQ(deck.element_count(), deck_.element_count());
}

// Of a plate of 1 m with shells of 20 mm.
TEST_F(PlacePoints, SensorMayStandHigherThanAFineMeshIsWide) {
  deck_ = structure::plate_deck({}, 50, 50);
  EXPECT_NEAR(
      placed(point_at({0.51, 0.47, 0.04})).measuring[0].off, 0.04, 1e-12);
  refuses(point_at({0.51, 0.47, 0.06}), "a sensor high (0.05 m)");
}

TEST_F(PlacePoints, WhatHasNoPlaceIsRefused) {
  // Shells are 30 mm wide, sensors as high as a tenth of the plate at most.
  refuses(point_at({0.1, 0.07, 0.051}), "farther than that is wide");
  EXPECT_NO_THROW((void)placed(point_at({0.1, 0.07, 0.029})));
  refuses(point_at_grid(99, skew), "no grid 99");
  deck_.shells.clear();
  refuses(point_at({0.1, 0.07, 0.0}), "no element");
  TestPoint above = point_at_grid(42, Matrix3d::Identity());
  above.height_m = 0.01;
  refuses(above, "no one normal");
}

class LaidOver : public PlacePoints {
 protected:
  // The test's axes: its X is the model's Z, from another origin.
  void SetUp() override {
    acquisition::TestGeometry geometry;
    geometry.file = "mesh.csv";
    const std::vector<Vector3d> on_model = {
        {0, 0, 0}, {0.3, 0, 0}, {0.3, 0.12, 0}, {0.1, 0.07, 0}};
    for (std::size_t k = 0; k < on_model.size(); ++k) {
      geometry.nodes[static_cast<int>(k) + 1] =
          turn_.transpose() * (on_model[k] - move_);
    }
    geometry.pairs = {{1, 1}, {2, 11}, {3, 55}};
    bundle_.geometry = geometry;
  }
  TestPoint node(int label) {
    TestPoint point = acquisition::own_point(*bundle_.geometry, label);
    point.place = "test.json: geometry";
    return point;
  }
  void fails_at(const std::vector<TestPoint>& points,
                const std::string& where,
                const std::string& what) {
    try {
      (void)placed(points);
      ADD_FAILURE() << "accepted, expected: " << what;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), where) << error.what();
      EXPECT_NE(error.fault().find(what), std::string::npos) << error.what();
    }
  }
  Matrix3d turn_ = (Matrix3d() << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished();
  Vector3d move_{1.0, -2.0, 0.5};
};

TEST_F(LaidOver, PairsBringPointsAndDirectionsToTheModel) {
  const structure::Deck deck = placed(node(4));
  ASSERT_TRUE(deck.laid_over.has_value());
  EXPECT_TRUE(deck.laid_over->rotation.isApprox(turn_, 1e-9));
  EXPECT_LT(deck.laid_over->rms_m, 1e-9);
  ASSERT_EQ(deck.measuring.size(), 1U);
  EXPECT_TRUE(
      deck.grids.front().position.isApprox(Vector3d(0.1, 0.07, 0), 1e-9));
  EXPECT_TRUE(direction_of(deck, {-4, 1, 1}).isApprox(Vector3d::UnitZ(), 1e-9));
  const auto H = frfs(deck, {{-4, 1, 1}});
  bundle_.geometry.reset();
  const auto same = frfs(placed(point_at({0.1, 0.07, 0.0})), {{-5, 3, 1}});
  EXPECT_LT((H[0] - same[0]).norm(), 1e-6 * same[0].norm());
}

TEST_F(LaidOver, WithoutPairsARectangleFitsInSeveralWays) {
  bundle_.geometry->pairs.clear();
  fails_at({node(1), node(2), node(3)}, "test.json: geometry", "ways");
}

// Measured points on a line say nothing of the turn about it: here the test's
// mesh stands upright on the plate's edge, and both lie on that edge.
TEST_F(LaidOver, WithoutPairsPointsOnALineLeaveATurnOpen) {
  acquisition::TestGeometry& g = *bundle_.geometry;
  g.pairs.clear();
  fails_at({node(4)}, "test.json: geometry", "on a line");
  g.nodes = {{1, {0, 0, 0}}, {2, {0.3, 0, 0}}, {3, {0.3, 0, 0.12}}};
  fails_at({node(1), node(2)}, "test.json: geometry", "on a line");
  // Where all of its nodes lie on the model, they are in the model's axes.
  g.nodes.at(3) = {0.3, 0.12, 0};
  const structure::Deck deck = placed({node(1), node(2)});
  ASSERT_TRUE(deck.laid_over.has_value());
  EXPECT_TRUE(deck.laid_over->rotation.isIdentity(0.0));
}

// A blow askew to the axes of a node has a number that is no node's.
TEST_F(LaidOver, PointsOfAnyNumberAreAtTheirNodes) {
  std::vector<TestPoint> points = {node(1), node(2), node(3)};
  for (TestPoint& point : points) point.label += 100;
  bundle_.geometry->pairs.clear();
  bundle_.geometry->nodes = {
      {1, {0, 0, 0}}, {2, {0.3, 0, 0}}, {3, {0.3, 0.12, 0}}};
  for (TestPoint& point : points) {
    point.at = bundle_.geometry->nodes.at(point.of_node);
  }
  const structure::Deck deck = placed(points);
  ASSERT_EQ(deck.measuring.size(), 3U);
  EXPECT_TRUE(deck.grids.front().position.isApprox(Vector3d(0.3, 0.12, 0)));
}

// Coordinates on the model need no mesh of the test's, be it laid over or not.
TEST_F(LaidOver, ATestWithoutItsNodesIsNotLaidOver) {
  bundle_.geometry->pairs.clear();
  const structure::Deck deck = placed(point_at({0.1, 0.07, 0.0}));
  EXPECT_FALSE(deck.laid_over.has_value());
  EXPECT_EQ(deck.measuring.size(), 1U);
}

TEST_F(LaidOver, PairsThatDoNotFitAreRefused) {
  const auto fails = [&](const std::string& where, const std::string& what) {
    fails_at({node(4)}, where, what);
  };
  acquisition::TestGeometry& g = *bundle_.geometry;
  g.pairs = {{1, 1}, {2, 11}, {3, 55}, {4, 9}};
  fails("test.json: geometry.pairs[3]", "farther than the mesh is wide");
  g.pairs = {{1, 1}, {2, 11}, {3, 999}};
  fails("test.json: geometry.pairs[2]", "no grid 999");
  g.pairs = {{1, 1}, {2, 11}, {3, 55}};
  for (auto& [label, x] : g.nodes) x *= 1000.0;
  fails("test.json: geometry.pairs", "0.001 times those of");
}

}  // namespace
}  // namespace tapfit::updating
