#include "tui/screen/csv_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tapfit::tui {
namespace {

// RFC 4180, section 2, rules 5 to 7.
TEST(CsvRow, QuotesWhatWouldBeReadAsSomethingElse) {
  EXPECT_EQ(csv_row({"a", "", "1.5"}), "a,,1.5\n");
  EXPECT_EQ(csv_row({"acc1, acc2", "say \"no\"", "two\nlines"}),
            "\"acc1, acc2\",\"say \"\"no\"\"\",\"two\nlines\"\n");
  EXPECT_EQ(csv_row({"a, b", "c\td"}, '\t'), "a, b\t\"c\td\"\n");
}

TEST(CsvNumber, LeavesOutWhatIsNone) {
  EXPECT_EQ(csv_number(0.1), "0.1");
  EXPECT_EQ(csv_number(1e-12), "1e-12");
  EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(csv_number(std::numeric_limits<double>::infinity()), "");
}

}  // namespace
}  // namespace tapfit::tui
