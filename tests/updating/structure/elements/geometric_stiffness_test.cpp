// Members under axial force against the closed forms of beam, string and
// column, and what a tension does to a rigid turn.
#include "updating/structure/elements/geometric_stiffness.hpp"

#include "tests/updating/support/deck_support.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

using std::numbers::pi;
constexpr double length = 0.8;
constexpr double youngs_modulus = 210e9;
constexpr double second_moment = 3e-9;
constexpr double bar_area = 2e-4;
constexpr double density = 7800.0;

// Pinned at both ends, free to bend in z alone.
Deck pinned_beam(int n) {
  Deck deck;
  deck.coupled_mass = true;
  deck.materials[1] = {
      1, false, youngs_modulus, 0.3, youngs_modulus / 2.6, density, 0, 0, 0};
  deck.bar_properties[1] = {
      1, 1, bar_area, second_moment, second_moment, 0.0, 2.0 * second_moment};
  for (int i = 0; i <= n; ++i) {
    deck.grids.push_back({i + 1, {length * i / n, 0.0, 0.0}});
  }
  for (int i = 1; i <= n; ++i) deck.bars.push_back(make_bar(i, 1, i, i + 1));
  hold(deck, "1246", [](const Eigen::Vector3d&) { return true; });
  hold(deck, "3", [](const Eigen::Vector3d& x) {
    return x.x() < 1e-9 || x.x() > length - 1e-9;
  });
  return deck;
}

void add_to(const Deck& deck,
            const GeometricMatrix& e,
            double force,
            SparseMatrix& K) {
  for (Eigen::Index i = 0; i < e.K.rows(); ++i) {
    for (Eigen::Index j = 0; j < e.K.cols(); ++j) {
      const auto at = [&](Eigen::Index k) {
        const int grid = e.grids[static_cast<std::size_t>(k / 6)];
        return 6 * static_cast<Eigen::Index>(deck.grid_index(grid)) + k % 6;
      };
      K.coeffRef(at(i), at(j)) += force * e.K(i, j);
    }
  }
}

// K of the deck with a tension in all bars and rods; its modes.
Eigen::VectorXd frequencies(const Deck& deck, double tension) {
  System system = assemble(deck);
  for (const Bar& bar : deck.bars) {
    add_to(deck, geometric_matrix(deck, bar), tension, system.K);
  }
  for (const Rod& rod : deck.rods) {
    add_to(deck, geometric_matrix(deck, rod), tension, system.K);
  }
  const FreeMotions motions = free_motions(system);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      Eigen::MatrixXd(motions.reduce(system.K)),
      Eigen::MatrixXd(motions.reduce(system.M)),
      Eigen::EigenvaluesOnly);
  // Below zero where it has buckled.
  return solver.eigenvalues().unaryExpr([](double lambda) {
    return std::copysign(std::sqrt(std::abs(lambda)), lambda) / (2.0 * pi);
  });
}

const double critical =
    pi * pi * youngs_modulus * second_moment / (length * length);

// f_n = n^2 pi / (2 L^2) sqrt(EI / m) sqrt(1 + T L^2 / (n^2 pi^2 EI)).
TEST(GeometricStiffness, PinnedBeamUnderTension) {
  const Deck deck = pinned_beam(16);
  for (const double share : {-0.5, 0.0, 1.0, 20.0}) {
    const Eigen::VectorXd f = frequencies(deck, share * critical);
    for (int n = 1; n <= 3; ++n) {
      const double bare =
          n * n * pi / (2.0 * length * length) *
          std::sqrt(youngs_modulus * second_moment / (density * bar_area));
      const double exact = bare * std::sqrt(1.0 + share / (n * n));
      // Cubic elements, 5 to a half wave at n = 3: fourth order.
      EXPECT_NEAR(f(n - 1) / exact, 1.0, 1e-3) << share << ' ' << n;
    }
  }
}

// Euler's load leaves the first frequency at nothing.
TEST(GeometricStiffness, ColumnBucklesAtEulersLoad) {
  const Deck deck = pinned_beam(8);
  EXPECT_GT(frequencies(deck, -0.999 * critical)(0), 0.0);
  EXPECT_LT(frequencies(deck, -1.001 * critical)(0), 0.0);
}

// f_n = n / (2 L) sqrt(T / m): rods have no stiffness across of their own.
TEST(GeometricStiffness, RodsAreAString) {
  constexpr int n = 40;
  Deck deck = pinned_beam(n);
  deck.bars.clear();
  deck.rod_properties[1] = {1, 1, bar_area, 0.0, 0.0};
  for (int i = 1; i <= n; ++i) deck.rods.push_back({i, 1, {i, i + 1}});
  hold(deck, "5", [](const Eigen::Vector3d&) { return true; });
  // Without tension nothing holds it across, and AUTOSPC would.
  SparseMatrix K(6 * (n + 1), 6 * (n + 1));
  for (const Rod& rod : deck.rods) {
    add_to(deck, geometric_matrix(deck, rod), 500.0, K);
  }
  const SparseMatrix M = assemble(deck).M;
  std::vector<int> across;
  for (int i = 1; i < n; ++i) across.push_back(6 * i + 2);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      Eigen::MatrixXd(extract(K, across)), Eigen::MatrixXd(extract(M, across)));
  for (int k = 1; k <= 3; ++k) {
    const double exact =
        k * pi / length * std::sqrt(500.0 / (density * bar_area));
    // Second order: (k pi / 40)^2 / 24 either way, by the mass.
    EXPECT_NEAR(std::sqrt(solver.eigenvalues()(k - 1)) / exact, 1.0, 3e-3);
  }
}

// A turn by theta lifts the ends of a bar under T by T L theta^2 / 2.
TEST(GeometricStiffness, TurningABarCostsTensionTimesLength) {
  Deck deck = pinned_beam(1);
  Bar bar = deck.bars.front();
  bar.offsets = {Eigen::Vector3d(0.1, 0.02, 0.0),
                 Eigen::Vector3d(0.0, 0.02, 0.3)};
  for (const bool pins : {false, true}) {
    if (pins) bar.released[0] = "5";
    const Eigen::Vector3d side =
        Eigen::Vector3d(length, 0.0, 0.0) + bar.offsets[1] - bar.offsets[0];
    const Eigen::MatrixXd K = geometric_matrix(deck, bar).K;
    const Eigen::Vector3d turn(0.3, -0.2, 0.5);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(12);
    for (Eigen::Index end = 0; end < 2; ++end) {
      const Eigen::Vector3d& x =
          deck.grids[static_cast<std::size_t>(end)].position;
      u.segment<3>(6 * end) = turn.cross(x);
      u.segment<3>(6 * end + 3) = turn;
    }
    const double across = turn.cross(side).squaredNorm() / side.norm();
    EXPECT_NEAR(u.dot(K * u), across, 1e-12 * across) << pins;
    // Shifted as a whole it costs nothing.
    u.setZero();
    u.segment<3>(0) = u.segment<3>(6) = turn;
    EXPECT_NEAR(u.dot(K * u), 0.0, 1e-12 * across);
  }
}

Deck one_shell(bool triangle) {
  Deck deck;
  deck.materials[1] = {1, false, 70e9, 0.3, 70e9 / 2.6, 2700.0, 0, 0, 0};
  deck.shell_properties[1] = {1, 1, 1, 1, 0.002};
  deck.grids = {{1, {0, 0, 0}}, {2, {0.3, 0.05, 0}}, {3, {0.35, 0.2, 0}}};
  deck.shells.push_back({1, 1, {1, 2, 3}});
  if (!triangle) {
    deck.grids.push_back({4, {-0.02, 0.17, 0}});
    deck.shells.front().grids.push_back(4);
  }
  return deck;
}

// A sheet under N tilted by a slope: N slope^2 area, whatever its corners.
TEST(GeometricStiffness, TiltingASheetCostsForceTimesArea) {
  Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
  N(0, 0) = 3.0;
  N(1, 1) = -1.0;
  N(0, 1) = N(1, 0) = 0.5;
  const Eigen::Vector3d slope(0.2, -0.4, 0.0);
  for (const bool triangle : {true, false}) {
    const Deck deck = one_shell(triangle);
    const Shell& shell = deck.shells.front();
    const GeometricMatrix e = geometric_matrix(deck, shell, N);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(e.K.rows());
    for (std::size_t i = 0; i < shell.grids.size(); ++i) {
      u(6 * static_cast<Eigen::Index>(i) + 2) =
          slope.dot(deck.grids[i].position);
    }
    const double exact = slope.dot(N * slope) * shell_plane(deck, shell).area;
    EXPECT_NEAR(u.dot(e.K * u), exact, 1e-12 * std::abs(exact)) << triangle;
  }
}

// N_x = E t / (1 - nu^2) e, N_y = nu N_x in a sheet stretched along x alone.
TEST(GeometricStiffness, StretchedSheetCarriesItsMembraneForce) {
  for (const bool triangle : {true, false}) {
    const Deck deck = one_shell(triangle);
    const Shell& shell = deck.shells.front();
    Eigen::MatrixX3d u(std::ssize(shell.grids), 3);
    for (std::size_t i = 0; i < shell.grids.size(); ++i) {
      u.row(static_cast<Eigen::Index>(i)) << 1e-4 * deck.grids[i].position.x(),
          0.0, 0.0;
    }
    const Eigen::Matrix3d N = membrane_force(shell_plane(deck, shell), u);
    const double exact = 70e9 * 0.002 / (1.0 - 0.09) * 1e-4;
    EXPECT_NEAR(N(0, 0), exact, 1e-9 * exact);
    EXPECT_NEAR(N(1, 1), 0.3 * exact, 1e-9 * exact);
    EXPECT_NEAR(N(0, 1), 0.0, 1e-9 * exact);
  }
}

}  // namespace
}  // namespace tapfit::structure
