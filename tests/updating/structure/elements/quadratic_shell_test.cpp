// CQUAD8, CTRIA6, laminates, offsets and shear panels.
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/shell_section.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <map>

namespace tapfit::structure {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The plate with a grid in the middle of every side.
Deck quadratic(Deck deck) {
  std::map<std::pair<int, int>, int> middles;
  int next = 100000;
  for (Shell& shell : deck.shells) {
    const std::size_t n = shell.grids.size();
    for (std::size_t k = 0; k < n; ++k) {
      const int a = shell.grids[k];
      const int b = shell.grids[(k + 1) % n];
      const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), next);
      if (fresh) {
        deck.grids.push_back(
            {next++, 0.5 * (deck.grid(a).position + deck.grid(b).position)});
      }
      shell.mids.push_back(place->second);
    }
  }
  return deck;
}

// Simply supported square: omega = 2 pi^2 / a^2 sqrt(D / (rho t)).
double square_hz(const Plate& plate) {
  const double nu = plate.material.nu;
  const double D =
      plate.material.E * std::pow(plate.thickness, 3) / (12 * (1 - nu * nu));
  return M_PI / (plate.a * plate.a) *
         std::sqrt(D / (plate.material.rho * plate.thickness));
}

// Edges do not turn along themselves (a hard support): then the closed form
// holds for shells with shear, too.
void support(Deck& deck) {
  const auto on_x = [](const Vector3d& x) {
    return std::min(x.x(), 1 - x.x()) < 1e-9;
  };
  const auto on_y = [](const Vector3d& x) {
    return std::min(x.y(), 1 - x.y()) < 1e-9;
  };
  hold(deck, "126", [](const Vector3d&) { return true; });
  hold(deck, "34", on_x);
  hold(deck, "35", on_y);
}

TEST(QuadraticShell, SimplySupportedSquare) {
  for (const bool triangles : {false, true}) {
    Plate plate;
    plate.triangles = triangles;
    Deck deck = quadratic(plate_deck(plate, 4, 4));
    support(deck);
    // Thickness a / 100: shear takes 0.05 %; the rest is the mesh of 4 x 4.
    EXPECT_NEAR(modes_of(deck, 1).frequency_hz(0),
                square_hz(plate),
                0.008 * square_hz(plate))
        << triangles;
  }
}

TEST(QuadraticShell, OnlyRigidMotionsHaveNoEnergyOnACurvedElement) {
  for (const bool triangles : {false, true}) {
    Plate plate;
    plate.triangles = triangles;
    plate.thickness = 0.1;
    Deck deck = quadratic(plate_deck(plate, 1, 1));
    for (Grid& grid : deck.grids) {
      const Vector3d x = grid.position;
      grid.position.z() = 0.1 * x.x() * x.x() - 0.07 * x.x() * x.y();
    }
    deck.shells[0].offset = 0.02;
    const ElementMatrices e = shell_matrices(deck, deck.shells[0]);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(e.K);
    const double most = solver.eigenvalues().maxCoeff();
    EXPECT_LT(solver.eigenvalues().head(6).cwiseAbs().maxCoeff(), 1e-11 * most);
    // The weakest motion is that of the drilling tie or the full integration.
    EXPECT_GT(solver.eigenvalues()(6), 1e-8 * most);
  }
}

// On a patch of parallelograms; other quadrilaterals of this kind hold a
// quadratic deflection nearly.
TEST(QuadraticShell, ConstantStrainsAreExactOnASkewedPatch) {
  for (const bool triangles : {false, true}) {
    Plate plate;
    plate.thickness = 0.1;
    plate.triangles = triangles;
    Deck deck = plate_deck(plate, 2, 2);
    for (Grid& grid : deck.grids) grid.position.x() += 0.4 * grid.position.y();
    deck = quadratic(deck);
    const System system = assemble(deck);
    // In the plane a linear field; w quadratic with its slopes.
    VectorXd u = VectorXd::Zero(system.dofs());
    for (std::size_t k = 0; k < deck.grids.size(); ++k) {
      const Vector3d x = deck.grids[k].position;
      auto own = u.segment<6>(6 * static_cast<Eigen::Index>(k));
      own(0) = 0.3 * x.x() + 0.2 * x.y();
      own(1) = 0.2 * x.x() - 0.4 * x.y();
      own(2) = 0.5 * x.x() * x.x() - 0.3 * x.x() * x.y() + 0.2 * x.y() * x.y();
      own(3) = -0.3 * x.x() + 0.4 * x.y();    // w,y
      own(4) = -(1.0 * x.x() - 0.3 * x.y());  // -w,x
    }
    const ShellSection s = shell_section(deck, deck.shells[0]);
    const Vector3d membrane(0.3, -0.4, 0.4);
    const Vector3d curvature(-1.0, -0.4, 0.6);
    const double expected = membrane.dot(s.membrane * membrane) +
                            curvature.dot(s.bending * curvature);
    EXPECT_NEAR(u.dot(system.K * u), expected, 1e-9 * expected) << triangles;
  }
}

TEST(Laminate, IsotropicPliesAreAPlate) {
  Plate plate;
  Deck deck = plate_deck(plate, 1, 1);
  const ShellSection whole = shell_section(deck, deck.shells[0]);
  ShellProperty& p = deck.shell_properties[1];
  p = {1, 0, 0, 0, plate.thickness};
  p.plies = {{1, 0.003, 20.0}, {1, 0.005, 0.0}, {1, 0.002, 70.0}};
  p.bottom = -0.005;
  const ShellSection laid = shell_section(deck, deck.shells[0]);
  EXPECT_LT((whole.membrane - laid.membrane).norm(),
            1e-12 * whole.membrane.norm());
  EXPECT_LT((whole.bending - laid.bending).norm(),
            1e-12 * whole.bending.norm());
  // 5/6 G t, a result here.
  EXPECT_NEAR(laid.shear_compliance(0, 0),
              whole.shear_compliance(0, 0),
              1e-9 * whole.shear_compliance(0, 0));
  EXPECT_NEAR(laid.mass, whole.mass, 1e-12 * whole.mass);
  EXPECT_NEAR(laid.rotary, whole.rotary, 1e-12 * whole.rotary);
  EXPECT_FALSE(laid.is_coupled());
}

// A laminate off its reference surface is the same plate on an offset: B and a
// part of D on the one hand, rigid arms on the other.
TEST(Laminate, Z0AndZoffsAreOneThing) {
  Plate plate;
  plate.thickness = 0.02;
  plate.shear = false;
  Deck by_offset = plate_deck(plate, 1, 1);
  by_offset.shells[0].offset = 0.03;
  Deck by_plies = plate_deck(plate, 1, 1);
  Material stiff = plate.material;
  stiff.orthotropic = true;
  stiff.E2 = stiff.E;
  by_plies.materials[1] = stiff;
  ShellProperty& p = by_plies.shell_properties[1];
  p = {1, 0, 0, 0, plate.thickness};
  p.plies = {{1, 0.02, 0.0}};
  p.bottom = 0.02;
  const auto energy = [](const Deck& deck, double z) {
    // Uniform curvature about the grids' plane: u = -z w,x has no membrane
    // strain there.
    VectorXd u = VectorXd::Zero(24);
    const ElementMatrices e = shell_matrices(deck, deck.shells[0]);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3d x = deck.grid(e.grids[k]).position;
      u(6 * static_cast<Eigen::Index>(k) + 2) = 0.5 * x.x() * x.x();
      u(6 * static_cast<Eigen::Index>(k) + 4) = -x.x();
    }
    static_cast<void>(z);
    return u.dot(e.K * u);
  };
  const double a = energy(by_offset, 0.03);
  const double b = energy(by_plies, 0.03);
  const double Q = plate.material.E / (1 - 0.09);
  const double expected = Q * (std::pow(0.02, 3) / 12 + 0.02 * 0.03 * 0.03);
  EXPECT_NEAR(a, expected, 1e-6 * expected);
  EXPECT_NEAR(b, expected, 1e-6 * expected);
}

// Two isotropic halves on each other: a cantilever of a bimetal strip, whose
// bending stiffness is that about its neutral axis.
TEST(Laminate, BimetalBendsAboutItsNeutralAxis) {
  Deck deck;
  deck.coupled_mass = true;
  const double E1 = 200e9;
  const double E2 = 50e9;
  deck.materials[1] = {1, false, E1, 0.0, E1 / 2, 8000.0, 0, 0, 0};
  deck.materials[2] = {2, false, E2, 0.0, E2 / 2, 2000.0, 0, 0, 0};
  ShellProperty p{1, 0, 0, 0, 0.02};
  p.plies = {{1, 0.01, 0.0}, {2, 0.01, 0.0}};
  p.bottom = -0.01;
  deck.shell_properties[1] = p;
  for (int i = 0; i <= 20; ++i) {
    deck.grids.push_back({2 * i + 1, {0.05 * i, 0.0, 0.0}});
    deck.grids.push_back({2 * i + 2, {0.05 * i, 0.05, 0.0}});
  }
  for (int i = 0; i < 20; ++i) {
    deck.shells.push_back(
        {i + 1, 1, {2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2}});
  }
  hold(deck, "123456", [](const Vector3d& x) { return x.x() < 1e-9; });
  hold(deck, "2", [](const Vector3d&) { return true; });
  // Per unit width.
  const double A = 0.01 * (E1 + E2);
  const double B = 0.5 * 1e-4 * (E2 - E1);
  const double D = 1e-6 / 3 * (E1 + E2);
  const double mass = 0.01 * (8000.0 + 2000.0);
  const double x = 1.8751041;
  const double hz = x * x / (2 * M_PI) * std::sqrt((D - B * B / A) / mass);
  // Shear and the mesh: 0.3 %.
  EXPECT_NEAR(modes_of(deck, 1).frequency_hz(0), hz, 0.005 * hz);
}

// A square panel between pinned rods: G t carries all of the shear.
TEST(ShearPanel, CarriesShearFlow) {
  Plate plate;
  plate.thickness = 0.002;
  Deck deck = plate_deck(plate, 1, 1);
  deck.shell_properties[1].panel = true;
  deck.coupled_mass = true;
  const ElementMatrices e = shell_matrices(deck, deck.shells[0]);
  VectorXd u = VectorXd::Zero(24);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector3d x = deck.grid(e.grids[k]).position;
    u(6 * static_cast<Eigen::Index>(k)) = x.y();  // unit shear
  }
  const double expected = plate.material.G * 0.002;
  EXPECT_NEAR(u.dot(e.K * u), expected, 1e-12 * expected);
  // The mass of the sheet, lumped.
  EXPECT_NEAR(e.M.trace(), 3.0 * 0.002 * plate.material.rho, 1e-9);
}

}  // namespace
}  // namespace tapfit::structure
