#include "updating/places/bars_in_line.hpp"

#include "tests/support/matchers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using structure::Deck;
using testing::Contains;
using testing::ElementsAre;

void add_grid(Deck& deck, int id, double x, double y) {
  structure::Grid grid;
  grid.id = id;
  grid.position = {x, y, 0.0};
  deck.grids.push_back(grid);
}

void add_bar(Deck& deck, int id, int from, int to) {
  structure::Bar bar;
  bar.id = id;
  bar.grids = {from, to};
  deck.bars.push_back(bar);
}

// A member of three bars with a branch at its second grid; the middle bar is
// written backwards.
Deck branched() {
  Deck deck;
  for (int k = 0; k < 4; ++k) add_grid(deck, k + 1, k, 0.0);
  add_grid(deck, 5, 1.0, 1.0);
  add_bar(deck, 11, 1, 2);
  add_bar(deck, 12, 3, 2);
  add_bar(deck, 13, 3, 4);
  add_bar(deck, 14, 2, 5);
  return deck;
}

TEST(BarsInLine, GoStraightOnPastABranch) {
  const auto runs = bars_in_line(branched(), 10);
  EXPECT_THAT(runs, Contains(ElementsAre(11, 12)));
  EXPECT_THAT(runs, Contains(ElementsAre(11, 12, 13)));
  EXPECT_THAT(runs, Contains(ElementsAre(13, 12)));
  for (const auto& run : runs) EXPECT_THAT(run, Not(Contains(14)));
}

TEST(BarsInLine, AreNoLongerThanAsked) {
  for (const auto& run : bars_in_line(branched(), 2)) EXPECT_EQ(run.size(), 2U);
}

TEST(BarsInLine, GoOnceAroundARing) {
  constexpr int count = 36;
  Deck deck;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    add_grid(deck, k + 1, std::cos(angle), std::sin(angle));
    add_bar(deck, k + 1, k + 1, (k + 1) % count + 1);
  }
  std::size_t longest = 0;
  for (const auto& run : bars_in_line(deck, 100)) {
    longest = std::max(longest, run.size());
  }
  EXPECT_EQ(longest, static_cast<std::size_t>(count));
}

}  // namespace
}  // namespace tapfit::updating
