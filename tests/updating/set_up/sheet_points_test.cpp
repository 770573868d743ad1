#include "updating/set_up/sheet_points.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::effects {
namespace {

class SheetPoints : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<Location> points() const {
    return written_points(support::plate_context(bundle_, deck_));
  }
  static Location at(const std::vector<std::string>& channels, int grid) {
    return {.nodes = {grid}, .channels = channels};
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
};

TEST_F(SheetPoints, AreEachHitAndEachSensorOnce) {
  const std::vector<Location> all = points();
  EXPECT_EQ(all.size(), 8U) << "six hits, two sensors that stay";
  EXPECT_TRUE(std::ranges::count(all, at({"hammer"}, 52)) == 1);
  EXPECT_TRUE(std::ranges::count(all, at({"acc2"}, 36)) == 1);
}

TEST_F(SheetPoints, OfOneGridAreOneSensorToo) {
  for (acquisition::Run& run : bundle_.runs) run.sensors[1].dof.node = 11;
  const std::vector<Location> all = points();
  EXPECT_EQ(all.size(), 9U);
  EXPECT_TRUE(std::ranges::count(all, at({"acc1", "acc2"}, 11)) == 1);
}

TEST_F(SheetPoints, OfSensorsArePartedByRuns) {
  const std::vector<Location> parts = parted_by_runs(at({"acc1"}, 11), bundle_);
  EXPECT_EQ(parts.size(), 10U) << "five cuts of six runs, both sides";
  const std::vector<int> from_fourth = {4, 5, 6};
  const std::vector<int> first_two = {1, 2};
  EXPECT_EQ(std::ranges::count(parts, from_fourth, &Location::runs), 1);
  EXPECT_EQ(std::ranges::count(parts, first_two, &Location::runs), 1);
  EXPECT_TRUE(parted_by_runs(at({"hammer"}, 52), bundle_).empty());
}

// Runs of one placement are averaged: their sensors cannot be told apart.
TEST_F(SheetPoints, AreNotPartedWithinAnAverage) {
  bundle_.runs[3].hammer.dof = bundle_.runs[2].hammer.dof;
  const std::vector<Location> parts = parted_by_runs(at({"acc1"}, 11), bundle_);
  EXPECT_EQ(parts.size(), 8U);
  const std::vector<int> from_fourth = {4, 5, 6};
  EXPECT_EQ(std::ranges::count(parts, from_fourth, &Location::runs), 0);
}

// A point that is hit again later: both runs are one average.
TEST_F(SheetPoints, ArePartedByWholeAverages) {
  bundle_.runs[4].hammer.dof = bundle_.runs[1].hammer.dof;
  const std::vector<Location> parts = parted_by_runs(at({"acc1"}, 11), bundle_);
  EXPECT_EQ(parts.size(), 8U);
  const std::vector<int> before = {1, 2, 3, 5};
  const std::vector<int> after = {4, 6};
  EXPECT_EQ(std::ranges::count(parts, before, &Location::runs), 1);
  EXPECT_EQ(std::ranges::count(parts, after, &Location::runs), 1);
}

TEST_F(SheetPoints, MeansChannelsAtItsGridInItsRuns) {
  Location where = at({"acc1"}, 11);
  where.runs = {2, 3};
  acquisition::TestBundle sheet = bundle_;
  for_each_meant(
      where, bundle_, sheet, [](acquisition::Placement& p) { p.dof.node = 7; });
  for (std::size_t r = 0; r < sheet.runs.size(); ++r) {
    const bool meant = r == 1 || r == 2;
    EXPECT_EQ(sheet.runs[r].sensors[0].dof.node, meant ? 7 : 11) << r;
    EXPECT_EQ(sheet.runs[r].sensors[1].dof.node, 36) << r;
    EXPECT_EQ(sheet.runs[r].hammer.dof, bundle_.runs[r].hammer.dof) << r;
  }
}

}  // namespace
}  // namespace tapfit::effects
