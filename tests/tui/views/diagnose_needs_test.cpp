#include "tui/views/diagnose_view.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

// A test of ready FRFs has neither, and can be diagnosed.
TEST(DiagnosePage, AsksForNoRecordings) {
  for (const Need& need : DiagnosePage().essential()) {
    EXPECT_NE(need.stage, Stage::Traces);
    EXPECT_NE(need.stage, Stage::Hits);
  }
}

}  // namespace
}  // namespace tapfit::tui
