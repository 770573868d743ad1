#include "updating/set_up/sheet_place.hpp"

#include "updating/set_up/mistakes.hpp"

#include <gtest/gtest.h>

namespace tapfit::effects {
namespace {

using Parts = std::vector<std::string>;

const Effect& point = point_mislabelled();

TEST(SheetPlace, IsAChannelTwoGridsAndRuns) {
  const Location where =
      read_sheet_place({"acc1", "8", "6", "run2", "run4-6"}, point);
  EXPECT_EQ(where.channels, Parts{"acc1"});
  EXPECT_EQ(where.nodes, std::vector{8});
  EXPECT_EQ(where.node, 6);
  EXPECT_EQ(where.runs, (std::vector{2, 4, 5, 6}));
}

TEST(SheetPlace, LeavesOpenWhatIsNotSaid) {
  const Location where = read_sheet_place({"x", "y", "6"}, point);
  EXPECT_EQ(where.channels, (Parts{"x", "y"}));
  EXPECT_EQ(where.node, 6);
  EXPECT_TRUE(where.nodes.empty());
  EXPECT_TRUE(where.runs.empty());
}

TEST(SheetPlace, TakesTheFirstNumberForAChannel) {
  const Location where = read_sheet_place({"3", "8", "6"}, point);
  EXPECT_EQ(where.channels, Parts{"3"});
  EXPECT_EQ(where.nodes, std::vector{8});
  EXPECT_EQ(where.node, 6);
}

TEST(SheetPlace, IsReadBackAsItIsWritten) {
  const Location where{.node = 6,
                       .nodes = {8},
                       .channels = {"acc1", "acc2"},
                       .runs = {1, 2, 3, 5, 8, 9}};
  const std::string text = sheet_place_text(where);
  EXPECT_EQ(text, "acc1:acc2:8:6:run1-3:run5:run8-9");
  EXPECT_EQ(read_sheet_place(
                {"acc1", "acc2", "8", "6", "run1-3", "run5", "run8-9"}, point),
            where);
}

TEST(SheetPlace, HasEachRunOnceInTheirOrder) {
  EXPECT_EQ(read_sheet_place({"acc1", "8", "6", "run4", "run2"}, point).runs,
            (std::vector{2, 4}));
  EXPECT_EQ(read_sheet_place({"acc1", "8", "6", "run2", "run2-4"}, point).runs,
            (std::vector{2, 3, 4}));
}

// As it is offered while it is typed.
TEST(SheetPlace, LeavesTheStructuresGridOpenBehindAColon) {
  Location where{.nodes = {8}, .channels = {"acc1"}};
  EXPECT_EQ(sheet_place_text(where), "acc1:8:");
  EXPECT_EQ(read_sheet_place({"acc1", "8", ""}, point), where);
  where.runs = {2};
  EXPECT_EQ(sheet_place_text(where), "acc1:8::run2");
  EXPECT_EQ(read_sheet_place({"acc1", "8", "", "run2"}, point), where);
}

TEST(SheetPlace, MayBeAPointOfTheTestsOwn) {
  const Location where{.nodes = {-3}, .channels = {"acc1"}, .variant = "+X"};
  EXPECT_EQ(sheet_place_text(where), "acc1:P3:+X");
  EXPECT_EQ(read_sheet_place({"acc1", "P3", "+X"}, direction_wrong()), where);
}

TEST(SheetPlace, HasADirectionBehindTheGridOfTheSheet) {
  const Location where =
      read_sheet_place({"acc1", "8", "-X", "run3"}, direction_wrong());
  EXPECT_EQ(where.nodes, std::vector{8});
  EXPECT_EQ(where.node, 0);
  EXPECT_EQ(where.variant, "-X");
  EXPECT_EQ(sheet_place_text(where), "acc1:8:-X:run3");
}

}  // namespace
}  // namespace tapfit::effects
