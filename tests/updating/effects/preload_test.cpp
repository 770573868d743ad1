// What carries the force of a member, by statics with closed forms.
#include "updating/effects/preload.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/effects/prestress.hpp"
#include "updating/structure/elements/geometric_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace tapfit::effects {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using structure::Deck;

// K_g of tensions by element id.
MatrixXd expected(const Deck& deck, const std::map<int, double>& tension) {
  const Index n = 6 * std::ssize(deck.grids);
  MatrixXd K = MatrixXd::Zero(n, n);
  const auto add = [&](const structure::GeometricMatrix& e, double N) {
    for (Index i = 0; i < 12; ++i) {
      for (Index j = 0; j < 12; ++j) {
        const auto at = [&](Index k) {
          const int grid = e.grids[static_cast<std::size_t>(k / 6)];
          return 6 * static_cast<Index>(deck.grid_index(grid)) + k % 6;
        };
        K(at(i), at(j)) += N * e.K(i, j);
      }
    }
  };
  for (const auto& bar : deck.bars) {
    if (tension.contains(bar.id)) {
      add(geometric_matrix(deck, bar), tension.at(bar.id));
    }
  }
  for (const auto& rod : deck.rods) {
    if (tension.contains(rod.id)) {
      add(geometric_matrix(deck, rod), tension.at(rod.id));
    }
  }
  return K;
}

Location at(const std::vector<int>& elements, const std::string& variant = "") {
  return {.elements = elements, .variant = variant};
}

Preload preload_of(const Deck& deck, const Location& where) {
  return preload(deck, structure::assemble(deck), where.elements, where);
}

void expect_same(const MatrixXd& found, const MatrixXd& exact, double least) {
  EXPECT_LT((found - exact).norm(), least * exact.norm());
}

// Four bars along (1, 1, 0), the last two of half the section.
Deck beam(bool both_ends) {
  Deck deck;
  deck.materials[1] = {1, false, 210e9, 0.3, 210e9 / 2.6, 7800.0, 0, 0, 0};
  deck.bar_properties[1] = {1, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};
  deck.bar_properties[2] = {2, 1, 2e-4, 3e-8, 1e-8, 0.0, 2e-8};
  const Vector3d along = Vector3d(1, 1, 0).normalized();
  for (int i = 0; i <= 4; ++i) deck.grids.push_back({i + 1, along * 0.1 * i});
  for (int i = 1; i <= 4; ++i) {
    deck.bars.push_back(structure::make_bar(i, i > 2 ? 2 : 1, i, i + 1));
  }
  deck.constraints.push_back({1, "123456"});
  if (both_ends) deck.constraints.push_back({5, "123456"});
  return deck;
}

// A wire at the tip pulls at all of a cantilever, and holds the tip across.
TEST(Preload, WireAtTheTipPullsAtAllOfIt) {
  const Deck deck = beam(false);
  const Location all = at({1, 2, 3, 4});
  const Preload unit = preload_of(deck, all);
  expect_same(unit.along,
              expected(deck, {{1, 1.0}, {2, 1.0}, {3, 1.0}, {4, 1.0}}),
              1e-6);
  const Vector3d axis = Vector3d(1, 1, 0).normalized();
  ASSERT_EQ(unit.side.rows(), 30);
  const MatrixXd side = unit.side;
  EXPECT_NEAR((side.block<3, 3>(24, 24) * axis).norm(), 0.0, 1e-12);
  EXPECT_NEAR(side(26, 26), 1.0, 1e-12);
  EXPECT_NEAR(side.trace(), 2.0, 1e-12);
  // No wire pushes.
  EXPECT_FALSE(can_carry(deck, at({1, 2, 3, 4}, "compression")));
}

// Of a member between two walls every section has the same force; nothing is
// held across.
TEST(Preload, HeldMemberCarriesOneForceThroughout) {
  const Deck deck = beam(true);
  const Preload pulled = preload_of(deck, at({1, 2, 3, 4}));
  const MatrixXd exact =
      expected(deck, {{1, 1.0}, {2, 1.0}, {3, 1.0}, {4, 1.0}});
  expect_same(pulled.along, exact, 1e-6);
  EXPECT_EQ(pulled.side.size(), 0);
  const Location pushed = at({1, 2, 3, 4}, "compression");
  EXPECT_TRUE(can_carry(deck, pushed));
  expect_same(preload_of(deck, pushed).along, -exact, 1e-6);
}

// A square with both diagonals, free in its plane, has one state of
// self-stress: diagonals T, sides -T / sqrt(2). It is in balance, so a rigid
// turn costs nothing.
TEST(Preload, SidesOfASquareBalanceItsDiagonals) {
  Deck deck;
  deck.materials[1] = {1, false, 70e9, 0.3, 70e9 / 2.6, 2700.0, 0, 0, 0};
  deck.rod_properties[1] = {1, 1, 1e-4, 0.0, 0.0};
  deck.rod_properties[2] = {2, 1, 3e-5, 0.0, 0.0};
  deck.grids = {{1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {1, 1, 0}}, {4, {0, 1, 0}}};
  deck.rods = {{1, 1, {1, 2}},
               {2, 1, {2, 3}},
               {3, 1, {3, 4}},
               {4, 1, {4, 1}},
               {5, 2, {1, 3}},
               {6, 1, {2, 4}}};
  structure::hold(deck, "3456", [](const Vector3d&) { return true; });
  // Grids held across a rod are no loose ends anyway: others are joined there.
  const MatrixXd K = preload_of(deck, at({5})).along;
  const double side = -std::sqrt(0.5);
  expect_same(
      K,
      expected(
          deck,
          {{1, side}, {2, side}, {3, side}, {4, side}, {5, 1.0}, {6, 1.0}}),
      1e-4);
  VectorXd turn = VectorXd::Zero(24);
  for (Index g = 0; g < 4; ++g) {
    const Vector3d& x = deck.grids[static_cast<std::size_t>(g)].position;
    turn(6 * g) = -x.y();
    turn(6 * g + 1) = x.x();
  }
  EXPECT_LT((K * turn).norm(), 1e-3 * K.norm());
}

// A sheet between two walls, nu = 0: the force is even across its width b, so
// that a tilt along it costs slope^2 a.
TEST(Preload, SheetCarriesItsForceEvenly) {
  structure::Plate plate;
  plate.a = 0.4;
  plate.b = 0.1;
  plate.material.nu = 0.0;
  plate.material.G = plate.material.E / 2.0;
  Deck deck = structure::plate_deck(plate, 8, 2);
  structure::hold(deck, "123456", [](const Vector3d& x) {
    return x.x() < 1e-9 || x.x() > 0.4 - 1e-9;
  });
  const std::vector<std::vector<int>> members = updating::whole_members(deck);
  ASSERT_EQ(members.size(), 1U);
  const MatrixXd K = preload_of(deck, at(members.front())).along;
  VectorXd along = VectorXd::Zero(K.rows());
  VectorXd across = along;
  for (std::size_t g = 0; g < deck.grids.size(); ++g) {
    const auto w = 6 * static_cast<Index>(g) + 2;
    along(w) = 0.2 * deck.grids[g].position.x();
    across(w) = 0.2 * deck.grids[g].position.y();
  }
  const double exact = 0.2 * 0.2 * 0.4;
  EXPECT_NEAR(along.dot(K * along), exact, 1e-4 * exact);
  EXPECT_NEAR(across.dot(K * across), 0.0, 1e-4 * exact);
}

// Whole members: a beam with a branch goes on past it; a folded plate is two
// sheets.
TEST(Members, AreWhole) {
  Deck deck = beam(false);
  deck.grids.push_back({6, {0.1, 0.0, 0.3}});
  deck.bars.push_back(structure::make_bar(5, 1, 3, 6));
  const auto members = updating::whole_members(deck);
  ASSERT_EQ(members.size(), 2U);
  EXPECT_EQ(members[0], (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(members[1], (std::vector<int>{5}));
  // The branch hangs at the beam: its own end is loose.
  EXPECT_NE(updating::axial_member(deck, {5}, false)->pulled(), nullptr);

  Deck fold = structure::plate_deck({}, 4, 2);
  for (structure::Grid& grid : fold.grids) {
    const double beyond = grid.position.x() - 0.5;
    if (beyond > 1e-9) grid.position += Vector3d(-beyond, 0.0, beyond);
  }
  EXPECT_EQ(updating::whole_members(fold).size(), 2U);
}

}  // namespace
}  // namespace tapfit::effects
