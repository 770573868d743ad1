#include "tui/views/candidate_table.hpp"

#include "tests/tui/support/fake_results.hpp"

#include <gtest/gtest.h>

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

// The scatter is left out where it does not fit, and only there.
TEST(CandidateTable, GivesTheSizeTheRoomThatIsLeft) {
  updating::Diagnosis d = testing::fake_diagnosis();
  EXPECT_EQ(candidate_table(d, {}, 80, false).rows[0].cells.back(),
            "0.07850 ± 0.00060 kg");
  // Bars give way first.
  d.candidates[0].effect = "a-kind-with-a-long-name";
  const Table cramped = candidate_table(d, {}, 80, false);
  EXPECT_EQ(cramped.rows[0].cells.back(), "0.07850 ± 0.00060 kg");
  EXPECT_EQ(cramped.columns.size(), cramped.rows[0].cells.size());
  d.candidates[0].effect = "a-kind-with-a-name-that-is-rather-long";
  EXPECT_EQ(candidate_table(d, {}, 80, false).rows[0].cells.back(),
            "0.0785 kg");
  d.candidates[0].effect =
      "a-kind-with-a-name-that-is-longer-than-any-other-is";
  EXPECT_EQ(candidate_table(d, {}, 130, false).rows[0].cells.back(),
            "mass 0.07850 ± 0.00060 kg");
}

}  // namespace
}  // namespace tapfit::tui
