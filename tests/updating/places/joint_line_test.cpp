#include "updating/places/joint_line.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace tapfit::updating {
namespace {

// 10 x 4 shells: nine lines across, three along.
TEST(JointPlaces, AreTheInnerLinesOfARaster) {
  const auto places = joint_places(support::plate_deck(true));
  const auto across =
      std::count_if(places.begin(), places.end(), [](const JointPlace& place) {
        return place.nodes.size() == 5;
      });
  const auto along =
      std::count_if(places.begin(), places.end(), [](const JointPlace& place) {
        return place.nodes.size() == 11;
      });
  EXPECT_EQ(across, 9);
  EXPECT_EQ(along, 3);
  EXPECT_EQ(places.size(), 12U);
}

TEST(JointPlaces, LinesInLineAreAlsoOne) {
  structure::Deck deck = support::plate_deck(false);
  // A slot along the middle row parts every line across but the outermost.
  std::erase_if(deck.shells, [](const structure::Shell& shell) {
    const int column = (shell.id - 1) % 10;
    const int row = (shell.id - 1) / 10;
    return row == 1 && column >= 1 && column < 9;
  });
  const auto places = joint_places(deck);
  // At x = 0.15 m: one edge below the slot, two above it, and both together.
  std::vector<std::size_t> sizes;
  for (const JointPlace& place : places) {
    const bool here =
        std::all_of(place.nodes.begin(), place.nodes.end(), [](int node) {
          return (node - 1) % 11 == 5;
        });
    if (here) sizes.push_back(place.nodes.size());
  }
  std::sort(sizes.begin(), sizes.end());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{2, 3, 5}));
}

TEST(ShellJoint, TakesOneSideAndTheWholeLength) {
  const structure::Deck deck = support::plate_deck(true);
  const std::vector<int> line = {6, 17, 28, 39, 50};
  const JointLine joint = shell_joint(deck, line);
  EXPECT_EQ(joint.grids.size(), 5U);
  EXPECT_NEAR(joint.length, 0.12, 1e-12);
  ASSERT_EQ(joint.side.size(), 4U);
  // All of them in one column beside x = 0.15 m.
  const int column = (joint.side.front() - 1) % 10;
  EXPECT_TRUE(column == 4 || column == 5);
  for (const int id : joint.side) EXPECT_EQ((id - 1) % 10, column);
  EXPECT_NEAR(std::abs(joint.grids.front().axis.y()), 1.0, 1e-12);
}

TEST(ShellJoint, IsTheSameLineOnASplitMesh) {
  const structure::RefinedDeck fine =
      structure::refine_mesh(support::plate_deck(true));
  const JointLine joint = shell_joint(fine.deck, {6, 17, 28, 39, 50});
  EXPECT_EQ(joint.grids.size(), 9U);
  EXPECT_NEAR(joint.length, 0.12, 1e-12);
  EXPECT_EQ(joint.side.size(), 8U);
}

TEST(BarJoint, TurnsAcrossTheBar) {
  structure::Deck deck;
  deck.grids = {{1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {2, 0, 0}}};
  for (int k = 0; k < 2; ++k) {
    structure::Bar bar;
    bar.id = 10 + k;
    bar.grids = {k + 1, k + 2};
    deck.bars.push_back(bar);
  }
  const auto places = joint_places(deck);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].nodes, std::vector<int>{2});
  const JointLine joint = bar_joint(deck, 2, {}, 3);
  ASSERT_EQ(joint.grids.size(), 1U);
  EXPECT_NEAR(std::abs(joint.grids[0].axis.y()), 1.0, 1e-12);
  EXPECT_TRUE(bar_joint(deck, 2, {}, 1).grids.empty());
  EXPECT_EQ(across_bar(deck, 2, {}, {1, 3, 2}), 3);
  EXPECT_EQ(across_bar(deck, 2, {}, {1}), 1);
}

}  // namespace
}  // namespace tapfit::updating
