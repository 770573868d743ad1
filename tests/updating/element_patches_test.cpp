#include "updating/element_patches.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

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

TEST(ElementPatches, AreDifferentAndLocal) {
  const auto patches = element_patches(support::plate_deck(true));
  const std::set<std::vector<int>> different(patches.begin(), patches.end());
  EXPECT_EQ(different.size(), patches.size());
  for (const auto& patch : patches) EXPECT_LE(patch.size(), 10U);
}

}  // namespace
}  // namespace tapfit::updating
