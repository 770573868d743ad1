#include "tui/views/candidate_table.hpp"

#include "tests/tui/support/fake_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

// Several rungs are each near certain: without their numbers the column of
// probabilities reads as if they were alternatives.
TEST(CandidateTable, NumbersTheRungsOfTheVerdict) {
  updating::Diagnosis d = testing::fake_diagnosis();
  updating::Candidate clamp = d.candidates[1];
  clamp.effect = "soft-support";
  clamp.where = {};
  clamp.where.nodes = {1, 2, 3};
  clamp.where.variant = "rotation";
  d.candidates.push_back(clamp);
  d.ladder = {{"added-mass|sensor-mass", d.candidates[0].where, 0.1, {}},
              {"soft-support", clamp.where, 0.038, {}}};
  for (const int width : {80, 120}) {
    const Table table = candidate_table(d, {}, width, false);
    EXPECT_EQ(table.rows[0].cells[0], "1");
    EXPECT_EQ(table.rows[1].cells[0], "");
    EXPECT_EQ(table.rows[2].cells[0], "2");
    EXPECT_EQ(table.columns.size(), table.rows[0].cells.size());
  }
}

TEST(CandidateTable, CutsNoPlaceInsideItsBrackets) {
  updating::Diagnosis d = testing::fake_diagnosis();
  updating::Location& where = d.candidates[0].where;
  where = {};
  where.variant = "rotation";
  for (int node = 1; node < 20; ++node) where.nodes.push_back(node);
  EXPECT_EQ(candidate_table(d, {}, 120, false).rows[0].cells[4],
            "rotation, 19 nodes");
}

std::string size_of(const Table& table) {
  const auto at =
      std::ranges::find(table.columns, std::string("size"), &Column::title);
  return table.rows[0].cells.at(
      static_cast<std::size_t>(at - table.columns.begin()));
}

// Sorted alike, however wide the window is.
TEST(CandidateTable, HasTheSameOrderInAnyWidth) {
  const updating::Diagnosis d = testing::fake_diagnosis();
  for (const char* column :
       {"rung", "probability", "where", "error", "hold-out error"}) {
    ListState state;
    state.sorted_by = column;
    state.rising = true;
    EXPECT_EQ(visible_rows(candidate_table(d, {}, 80, true), state),
              visible_rows(candidate_table(d, {}, 200, false), state))
        << column;
  }
}

// The scatter is left out where it does not fit, and only there.
TEST(CandidateTable, GivesTheSizeTheRoomThatIsLeft) {
  updating::Diagnosis d = testing::fake_diagnosis();
  EXPECT_EQ(size_of(candidate_table(d, {}, 80, false)), "0.07850 ± 0.00060 kg");
  // Bars give way first.
  d.candidates[0].effect = "a-kind-with-a-long-name";
  const Table cramped = candidate_table(d, {}, 80, false);
  EXPECT_EQ(size_of(cramped), "0.07850 ± 0.00060 kg");
  EXPECT_EQ(cramped.columns.size(), cramped.rows[0].cells.size());
  d.candidates[0].effect = "a-kind-with-a-name-that-is-rather-long";
  EXPECT_EQ(size_of(candidate_table(d, {}, 80, false)), "0.0785 kg");
  d.candidates[0].effect =
      "a-kind-with-a-name-that-is-longer-than-any-other-is";
  EXPECT_EQ(candidate_table(d, {}, 130, false).rows[0].cells.back(),
            "mass 0.07850 ± 0.00060 kg");
}

}  // namespace
}  // namespace tapfit::tui
