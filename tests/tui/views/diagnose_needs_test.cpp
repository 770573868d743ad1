#include "tests/tui/support/fake_results.hpp"
#include "tui/views/diagnose_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace tapfit::tui {
namespace {

// A test of ready FRFs has neither, and can be diagnosed.
TEST(DiagnosePage, AsksForNoRecordings) {
  for (const Need& need : DiagnosePage().essential()) {
    EXPECT_NE(need.stage, Stage::Traces);
    EXPECT_NE(need.stage, Stage::Hits);
  }
}

// What led while candidates were still tried is not what was found.
TEST(DiagnosePage, StandsOnTheVerdictWhereNothingElseWasChosen) {
  auto found = std::make_shared<updating::Diagnosis>(testing::fake_diagnosis());
  auto tried = std::make_shared<updating::Diagnosis>(*found);
  std::ranges::reverse(tried->candidates);
  Snapshot before;
  before.preliminary = tried;
  Snapshot now;
  now.diagnosis = found;
  DiagnosePage page;
  page.follow(before, now);
  EXPECT_EQ(page.list()->selected, 0U);
  page.list()->selected = 1;  // that of the verdict, as it was listed
  page.follow(before, now);
  EXPECT_EQ(page.list()->selected, 0U);
  page.list()->selected = 1;
  page.follow(now, before);
  EXPECT_EQ(page.list()->selected, 0U);
}

}  // namespace
}  // namespace tapfit::tui
