#include "updating/structure/mesh/refine_mesh.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <cmath>

namespace tapfit::structure {
namespace {

TEST(RefineMesh, SplitsShellsAndBarsOnSharedEdges) {
  Deck deck = plate_deck({}, 2, 1);
  deck.bar_properties[7] = {7, 1, 1e-4, 1e-9, 1e-9, 0, 1e-9};
  deck.bars.push_back(make_bar(50, 7, 1, 3));
  deck.bars[0].released = {"5", "6"};
  deck.bars[0].offsets[1].z() = 0.02;
  deck.masses.push_back({60, 6, 0.5});
  deck.constraints = {{1, "123"}, {2, "13456"}, {3, "3"}};
  const RefinedDeck fine = refine_mesh(deck);
  EXPECT_EQ(fine.deck.grids.size(), 15u);  // 5 x 3
  EXPECT_EQ(fine.deck.shells.size(), 8u);
  ASSERT_EQ(fine.deck.bars.size(), 2u);
  EXPECT_EQ(fine.children.at(1).size(), 4u);
  EXPECT_EQ(fine.children.at(60), std::vector<int>{60});
  EXPECT_EQ(fine.deck.bars[0].released[0], "5");
  EXPECT_EQ(fine.deck.bars[0].released[1], "");
  EXPECT_EQ(fine.deck.bars[1].released[1], "6");
  EXPECT_EQ(fine.deck.bars[1].offsets[0].z(), 0.01);
  // The bar's middle is the shells' grid on the edge 1-3.
  const int middle = fine.deck.bars[0].grids[1];
  EXPECT_EQ(fine.between.at(middle), (std::vector<int>{1, 3}));
  int held = 0;
  for (const Constraint& c : fine.deck.constraints) {
    if (c.grid <= 6) continue;
    ++held;
    EXPECT_EQ(c.components, c.grid == middle ? "3" : "13");
  }
  EXPECT_EQ(held, 2);
}

TEST(RefineMesh, KeepsMassAndAreaAndLowersTheError) {
  for (const bool triangles : {false, true}) {
    Deck deck = plate_deck(
        {.b = 0.7, .thickness = 0.002, .shear = false, .triangles = triangles},
        4,
        4);
    hold(deck, "123456", [](const Eigen::Vector3d& p) { return p.x() < 1e-9; });
    const Deck once = refine_mesh(deck).deck;
    const Deck twice = refine_mesh(once).deck;
    const double mass = total_mass(deck, assemble(deck));
    EXPECT_NEAR(total_mass(twice, assemble(twice)), mass, 1e-9 * mass);
    const Eigen::VectorXd f0 = modes_of(deck, 5).frequency_hz;
    const Eigen::VectorXd f1 = modes_of(once, 5).frequency_hz;
    const Eigen::VectorXd f2 = modes_of(twice, 5).frequency_hz;
    // Second order would be a quarter; without shear, whose edge layer a finer
    // mesh resolves more and more.
    EXPECT_LT((f2 - f1).norm(), 0.4 * (f1 - f0).norm()) << triangles;
  }
}

TEST(RefineMesh, KeepsTheMaterialAxis) {
  Deck deck = plate_deck({.triangles = true}, 2, 2);
  deck.materials[1] = {1, true, 1e10, 0.3, 5e8, 400.0, 1e9, 0, 0};
  for (Shell& shell : deck.shells) shell.theta_deg = 20.0;
  const Deck fine = refine_mesh(deck).deck;
  // The rigid and constant strain energies of parent and children agree only
  // with the axis kept: stretch along x.
  const auto energy = [](const Deck& d) {
    const System system = assemble(d);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(system.dofs());
    for (std::size_t i = 0; i < d.grids.size(); ++i) {
      u(6 * static_cast<Eigen::Index>(i)) = d.grids[i].position.x();
    }
    return u.dot(system.K * u);
  };
  EXPECT_NEAR(energy(fine) / energy(deck), 1.0, 1e-9);
}

}  // namespace
}  // namespace tapfit::structure
