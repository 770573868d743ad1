#include "tui/report/text_table.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCell) {
  TextTable table({"<name", "Hz"});
  table.add({"a", "12.25"});
  table.add({"longer", "1"});
  EXPECT_EQ(table.text(),
            "  name       Hz\n"
            "  a       12.25\n"
            "  longer      1\n");
}

TEST(TextTable, MissingCellsAreEmptyAndNoBlanksTrail) {
  TextTable table({"<name", "<note"});
  table.add({"a"});
  EXPECT_EQ(table.text(), "  name  note\n  a\n");
}

TEST(TextTable, WidthCountsCharactersNotBytes) {
  EXPECT_EQ(shown_width("Gr\xC3\xB6\xC3\x9F"
                        "e"),
            5U);
}

TEST(Percent, KeepsTwoDigitsOfSmallErrors) {
  EXPECT_EQ(percent(0.388), "38.8 %");
  EXPECT_EQ(percent(0.0007), "0.07 %");
  EXPECT_EQ(percent(1.25), "125.0 %");
}

}  // namespace
}  // namespace tapfit::tui
