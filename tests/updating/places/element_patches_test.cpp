#include "updating/places/element_patches.hpp"

#include "tests/support/matchers.hpp"
#include "tests/updating/support/sample_plate.hpp"

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

using testing::Contains;
using testing::ElementsAre;

TEST(ElementPatches, HoldEveryElementAlone) {
  const auto patches = element_patches(support::plate_deck(true));
  const auto single =
      std::count_if(patches.begin(), patches.end(), [](const auto& patch) {
        return patch.size() == 1;
      });
  EXPECT_EQ(single, 40);
}

TEST(ElementPatches, HoldBoxesAroundElementsAndGrids) {
  const auto patches = element_patches(support::plate_deck(true));
  const std::vector<int> around_grid = {14, 15, 24, 25};
  const std::vector<int> around_element = {4, 5, 6, 14, 15, 16, 24, 25, 26};
  EXPECT_NE(std::find(patches.begin(), patches.end(), around_grid),
            patches.end());
  EXPECT_NE(std::find(patches.begin(), patches.end(), around_element),
            patches.end());
}

TEST(ElementPatches, HoldTheTwoBesideAnEdge) {
  const auto patches = element_patches(support::plate_deck(true));
  EXPECT_THAT(patches, Contains(ElementsAre(14, 15)));
  EXPECT_THAT(patches, Contains(ElementsAre(14, 24)));
}

TEST(ElementPatches, HoldBarsInLineAndRods) {
  structure::Deck deck;
  for (int k = 0; k < 9; ++k) {
    structure::Grid grid;
    grid.id = k + 1;
    grid.position = {0.1 * k, 0.0, 0.0};
    deck.grids.push_back(grid);
  }
  for (int k = 0; k < 8; ++k) {
    structure::Bar bar;
    bar.id = k + 1;
    bar.grids = {k + 1, k + 2};
    deck.bars.push_back(bar);
    structure::Rod rod;
    rod.id = k + 11;
    rod.grids = bar.grids;
    deck.rods.push_back(rod);
  }
  const auto patches = element_patches(deck);
  EXPECT_THAT(patches, Contains(ElementsAre(11)));
  EXPECT_THAT(patches, Contains(ElementsAre(3, 4, 5)));
}

TEST(ElementPatches, AreDifferentAndLocal) {
  const auto patches = element_patches(support::plate_deck(true));
  const std::set<std::vector<int>> different(patches.begin(), patches.end());
  EXPECT_EQ(different.size(), patches.size());
  for (const auto& patch : patches) EXPECT_LE(patch.size(), 10U);
}

}  // namespace
}  // namespace tapfit::updating
