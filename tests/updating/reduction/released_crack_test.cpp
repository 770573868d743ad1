// A crack against the same deck with doubled grids and springs between them.
#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/places/crack_line.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

using structure::Deck;

Deck parted(const Deck& whole, const CrackLine& crack, double k) {
  Deck deck = whole;
  int id = 9000;
  const auto spring = [&](int node, int twin, int component, double stiffness) {
    structure::ScalarElement element;
    element.id = id++;
    element.grids = {node, twin};
    element.components = {component, component};
    element.stiffness = stiffness;
    deck.scalars.push_back(element);
  };
  for (const PartedGrid& grid : crack.grids) {
    structure::Grid twin = deck.grids[deck.grid_index(grid.node)];
    twin.id += 1000;
    deck.grids.push_back(twin);
    for (structure::Shell& shell : deck.shells) {
      if (std::ranges::find(crack.side, shell.id) == crack.side.end()) continue;
      std::ranges::replace(shell.grids, grid.node, twin.id);
    }
    for (int c = 1; c <= 3; ++c) {
      spring(grid.node, twin.id, c, k * grid.area);
    }
    // The line runs along y, the plate lies across z.
    for (const int c : {4, 5}) spring(grid.node, twin.id, c, k * grid.turn);
  }
  return deck;
}

TEST(ReleasedCrack, HasTheModesOfADeckThatIsParted) {
  const Deck whole = support::plate_deck(true);
  const CrackLine crack = crack_line(whole, {6, 17, 28});
  StiffnessChange change;
  change.kind = ChangeKind::Joint;
  change.of.where.nodes = {6, 17, 28};
  change.of.where.variant = updating::crack;
  const structure::System system = structure::assemble(whole);
  const ReleasedSystem released = release({whole, {}, {}},
                                          system,
                                          nothing_released(system, {}),
                                          ElementParts(whole, {}),
                                          {change});
  const Eigen::VectorXd intact = structure::modes_of(whole, 6).frequency_hz;
  for (const double k : {1e6, 1e11, 1e16}) {
    const structure::SparseMatrix K =
        released.K.whole() + k * released.scaled.front().S;
    const Eigen::VectorXd found =
        structure::eigenmodes(
            structure::extract(K, released.active),
            structure::extract(released.M.whole(), released.active),
            6)
            .frequency_hz;
    const Eigen::VectorXd direct =
        structure::modes_of(parted(whole, crack, k), 6).frequency_hz;
    // What the eigensolver leaves of a stiffness of 1e16 beside that of a
    // plate.
    EXPECT_LT((found - direct).cwiseQuotient(direct).cwiseAbs().maxCoeff(),
              1e-6)
        << k;
    const double fall = (1.0 - found.cwiseQuotient(intact).array()).maxCoeff();
    if (k == 1e6) {
      EXPECT_GT(fall, 0.01);
    } else if (k == 1e16) {
      EXPECT_LT(fall, 1e-4);
    }
  }
}

// Elements on the side of a crack part with it: all of them lose all of the
// stiffness that there is but for the springs.
TEST(ReleasedCrack, TakesTheStiffnessOfElementsBesideItWithIt) {
  const Deck whole = support::plate_deck(true);
  StiffnessChange crack;
  crack.kind = ChangeKind::Joint;
  crack.of.where.nodes = {6, 17, 28};
  crack.of.where.variant = updating::crack;
  StiffnessChange loss;
  loss.kind = ChangeKind::Elements;
  for (const structure::Shell& shell : whole.shells) {
    loss.of.where.elements.push_back(shell.id);
  }
  loss.of.where.variant = pocket;
  const structure::System system = structure::assemble(whole);
  const ReleasedSystem released = release({whole, {}, {}},
                                          system,
                                          nothing_released(system, {}),
                                          ElementParts(whole, {}),
                                          {crack, loss});
  ASSERT_EQ(released.scaled.size(), 2U);
  const ScaledStiffness& lost = released.scaled.back();
  const structure::SparseMatrix all = lost.S + lost.thickness.K;
  EXPECT_LT((released.K.whole() - all).norm(), 1e-12 * all.norm());
  EXPECT_LT((released.M.whole() - lost.thickness.M).norm(),
            1e-12 * lost.thickness.M.norm());
}

}  // namespace
}  // namespace tapfit::updating
