#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/mistakes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::effects {
namespace {

class Mislabelled : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<Location> places() const {
    return point_mislabelled().places(support::plate_context(bundle_, deck_));
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
};

TEST_F(Mislabelled, AreGridsOfTheSheetWithTheOtherLeftOpen) {
  const std::vector<Location> all = places();
  EXPECT_EQ(all.size(), 28U) << "8 points, 2 sensors parted by 5 cuts";
  for (const Location& where : all) EXPECT_EQ(where.node, 0);
}

// Component X of P3 is along an axis of P3's own, which is none of grid 8.
TEST_F(Mislabelled, AreNoPointsOfTheTestsOwn) {
  for (acquisition::Run& run : bundle_.runs) run.sensors[1].dof.node = -3;
  const std::vector<Location> all = places();
  EXPECT_EQ(all.size(), 17U) << "those of the hammer and acc1";
  EXPECT_TRUE(std::ranges::none_of(
      all, [](const Location& where) { return where.nodes.front() < 0; }));
}

}  // namespace
}  // namespace tapfit::effects
