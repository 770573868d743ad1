#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/solve/factor.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

using Exact = std::function<Eigen::VectorXd(const Eigen::Vector3d&)>;

// MacNeal and Harder's distorted patch (grids 5 to 8 inside).
Deck patch(bool triangles, bool shear) {
  Deck deck;
  deck.materials[1] = {1, false, 1e6, 0.25, 0.4e6, 1.0, 0, 0, 0};
  deck.shell_properties[1] = {1, 1, 1, shear ? 1 : 0, 0.001};
  deck.grids = {{1, {0, 0, 0}},
                {2, {0.24, 0, 0}},
                {3, {0.24, 0.12, 0}},
                {4, {0, 0.12, 0}},
                {5, {0.04, 0.02, 0}},
                {6, {0.18, 0.03, 0}},
                {7, {0.16, 0.08, 0}},
                {8, {0.08, 0.08, 0}}};
  const std::vector<std::vector<int>> quads{
      {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}, {5, 6, 7, 8}};
  int id = 1;
  for (const std::vector<int>& q : quads) {
    if (!triangles) {
      deck.shells.push_back({id++, 1, q});
      continue;
    }
    deck.shells.push_back({id++, 1, {q[0], q[1], q[2]}});
    deck.shells.push_back({id++, 1, {q[0], q[2], q[3]}});
  }
  return deck;
}

// Largest error inside when the corners move as the exact field says.
double patch_error(const Deck& deck, const Exact& exact) {
  const System system = assemble(deck);
  Eigen::VectorXd u(48);
  for (std::size_t i = 0; i < 8; ++i) {
    u.segment<6>(6 * static_cast<Eigen::Index>(i)) =
        exact(deck.grids[i].position);
  }
  const Eigen::MatrixXd K = system.K;
  const Eigen::VectorXd inside = K.bottomRightCorner(24, 24).ldlt().solve(
      -K.bottomLeftCorner(24, 24) * u.head(24));
  return (inside - u.tail(24)).lpNorm<Eigen::Infinity>() /
         u.lpNorm<Eigen::Infinity>();
}

Eigen::VectorXd stretched(const Eigen::Vector3d& p) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(6);
  u(0) = 1e-3 * (p.x() + p.y() / 2);
  u(1) = 1e-3 * (p.y() + p.x() / 2);
  return u;
}

Eigen::VectorXd bent(const Eigen::Vector3d& p) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(6);
  u(2) = 0.5e-3 * (p.x() * p.x() + p.x() * p.y() + p.y() * p.y());
  u(3) = 1e-3 * (p.y() + p.x() / 2);
  u(4) = -1e-3 * (p.x() + p.y() / 2);
  return u;
}

// Rounding of a 24-dof solve whose stiffnesses span ten decades.
constexpr double patch_rounding = 1e-7;

TEST(ShellElement, PassesThePatchTests) {
  for (const bool triangles : {false, true}) {
    for (const bool shear : {false, true}) {
      const Deck deck = patch(triangles, shear);
      EXPECT_LT(patch_error(deck, stretched), patch_rounding)
          << triangles << shear;
      EXPECT_LT(patch_error(deck, bent), patch_rounding) << triangles << shear;
    }
  }
}

TEST(ShellElement, HoldsTheEnergyOfConstantCurvature) {
  // U = 1/2 A k' D k with k = 1e-3 (1, 1, 1).
  const Deck deck = patch(false, true);
  const System system = assemble(deck);
  Eigen::VectorXd u(48);
  for (std::size_t i = 0; i < 8; ++i) {
    u.segment<6>(6 * static_cast<Eigen::Index>(i)) =
        bent(deck.grids[i].position);
  }
  const double D = 1e6 * 1e-9 / 12 / (1 - 0.0625);
  const double density = 0.5 * D * 1e-6 * (2 + 2 * 0.25 + 0.375);
  EXPECT_NEAR(0.5 * u.dot(system.K * u) / (density * 0.24 * 0.12), 1.0, 1e-9);
}

Deck warped(bool triangle) {
  Deck deck = plate_deck({.triangles = false}, 1, 1);
  deck.grids[0].position = {0.1, 0.0, 0.05};
  deck.grids[1].position = {0.0, 1.1, -0.05};
  deck.grids[2].position = {0.9, 0.2, 0.3};
  deck.grids[3].position = {1.2, 1.0, 0.4};
  if (triangle) deck.shells[0].grids.pop_back();
  return deck;
}

TEST(ShellElement, HasSixRigidMotionsAndNoMore) {
  for (const bool triangle : {false, true}) {
    const Deck deck = warped(triangle);
    const ElementMatrices e = shell_matrices(deck, deck.shells[0]);
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(e.K).eigenvalues();
    const double largest = values.maxCoeff();
    EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-13 * largest);
    EXPECT_GT(values(6), 1e-8 * largest);
  }
}

// Basic rigid motion about the origin.
Eigen::VectorXd rigid(const Deck& deck,
                      const Shell& shell,
                      const Eigen::Vector3d& shift,
                      const Eigen::Vector3d& turn) {
  Eigen::VectorXd u(6 * static_cast<Eigen::Index>(shell.grids.size()));
  for (std::size_t i = 0; i < shell.grids.size(); ++i) {
    const Eigen::Vector3d& p = deck.grid(shell.grids[i]).position;
    u.segment<6>(6 * static_cast<Eigen::Index>(i)) << shift + turn.cross(p),
        turn;
  }
  return u;
}

TEST(ShellElement, CarriesItsMassInRigidMotion) {
  Deck deck = plate_deck({.a = 2.0, .b = 1.0, .thickness = 0.01}, 1, 1);
  const double mass = 2.0 * 0.01 * 8000.0;
  for (const bool coupled : {false, true}) {
    deck.coupled_mass = coupled;
    const Shell& shell = deck.shells[0];
    const ElementMatrices e = shell_matrices(deck, shell);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::VectorXd u =
          rigid(deck, shell, Eigen::Vector3d::Unit(axis), {0, 0, 0});
      EXPECT_NEAR(u.dot(e.M * u), mass, 1e-9 * mass);
    }
    if (!coupled) continue;
    // About the edge x = 0: m a^2 / 3 and the rotary inertia m t^2 / 12.
    const Eigen::VectorXd u =
        rigid(deck, shell, {0, 0, 0}, Eigen::Vector3d::UnitY());
    const double inertia = mass * (4.0 / 3.0 + 1e-4 / 12.0);
    EXPECT_NEAR(u.dot(e.M * u), inertia, 1e-9 * inertia);
  }
}

TEST(ShellElement, TurnsWithTheStructure) {
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  for (const bool coupled : {false, true}) {
    const Deck deck = plate_deck({.coupled = coupled}, 6, 6);
    Deck turned = deck;
    for (Grid& grid : turned.grids) grid.position = R * grid.position;
    const Eigen::VectorXd a = modes_of(deck, 12).frequency_hz.tail(6);
    const Eigen::VectorXd b = modes_of(turned, 12).frequency_hz.tail(6);
    // Rounding only.
    EXPECT_LT(((a - b).array() / a.array()).abs().maxCoeff(), 1e-7) << coupled;
    // Lumped masses couple nothing, whichever way the plate lies.
    const bool diagonal = assemble(turned).M.toDense().isDiagonal();
    EXPECT_EQ(diagonal, !coupled);
  }
}

TEST(ShellElement, FollowsTheMaterialAxis) {
  // E1 along x by theta = 90 from side 1-2 along y.
  Deck deck = plate_deck({}, 1, 1);
  deck.materials[1] = {1, true, 1e10, 0.3, 5e8, 400.0, 1e9, 0, 0};
  Deck other = deck;
  std::swap(other.materials[1].E, other.materials[1].E2);
  other.materials[1].nu = 0.03;  // nu12 / E1 is symmetric
  other.shells[0].theta_deg = 90.0;
  const ElementMatrices a = shell_matrices(deck, deck.shells[0]);
  const ElementMatrices b = shell_matrices(other, other.shells[0]);
  EXPECT_LT((a.K - b.K).norm(), 1e-10 * a.K.norm());
}

// Moment that turns the middle grid of a sheet of n x n elements with a held
// edge by one about the normal.
double turning_stiffness(bool triangles, int n) {
  Deck deck = plate_deck({.triangles = triangles}, n, n);
  const System system = assemble(deck);
  std::vector<Eigen::Index> free;
  Eigen::Index middle = -1;
  for (std::size_t i = 0; i < deck.grids.size(); ++i) {
    const Eigen::Vector3d from =
        deck.grids[i].position - Eigen::Vector3d(0.5, 0.5, 0.0);
    if (from.cwiseAbs().maxCoeff() > 0.5 - 1e-9) continue;
    if (from.norm() < 1e-9) middle = static_cast<Eigen::Index>(free.size()) + 2;
    for (const Eigen::Index c : {0, 1, 5}) {
      free.push_back(6 * static_cast<Eigen::Index>(i) + c);
    }
  }
  const Eigen::MatrixXd K = Eigen::MatrixXd(system.K)(free, free);
  const Eigen::VectorXd load = Eigen::VectorXd::Unit(K.rows(), middle);
  return 1.0 / K.llt().solve(load)(middle);
}

// A rigid disc of radius r in a wide sheet resists with 4 pi G t r^2. One grid
// is as a disc of some part of its elements' size, and of the same part however
// fine they are, or moments and offset masses turn it as though it were loose.
TEST(ShellElement, HoldsOneGridAgainstTurningAboutTheNormal) {
  const double G = Plate{}.material.G;
  for (const bool triangles : {false, true}) {
    std::vector<double> part;
    for (const int n : {8, 16, 32}) {
      const double K = turning_stiffness(triangles, n);
      part.push_back(
          n * std::sqrt(K / (4.0 * std::numbers::pi * G * Plate{}.thickness)));
    }
    EXPECT_LT(part.front(), 1.0 / 2.0);
    EXPECT_GT(part.front(), 1.0 / 20.0);
    EXPECT_GT(part.back(), 0.99 * part.front());
  }
}

TEST(ShellElement, RefusesBadShapes) {
  Deck deck = plate_deck({}, 1, 1);
  std::swap(deck.shells[0].grids[1], deck.shells[0].grids[2]);
  EXPECT_THROW(static_cast<void>(assemble(deck)), InputError);
  deck = plate_deck({.triangles = true}, 1, 1);
  deck.grids[3].position = {0.5, 0.0, 0.0};
  deck.grids[2].position = {0.25, 0.0, 0.0};
  EXPECT_THROW(static_cast<void>(assemble(deck)), InputError);
}

}  // namespace
}  // namespace tapfit::structure
