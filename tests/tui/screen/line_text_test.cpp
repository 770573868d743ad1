#include "tui/screen/line_text.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(LineText, TakesTheLongestWordingThatFits) {
  EXPECT_EQ(fitting({"coherence 0.98", "coh 0.98"}, 14), "coherence 0.98");
  EXPECT_EQ(fitting({"coherence 0.98", "coh 0.98"}, 13), "coh 0.98");
  EXPECT_EQ(fitting({"coherence 0.98", "coh 0.98"}, 2), "coh 0.98");
}

TEST(LineText, SaysHowManyItemsDoNotFit) {
  const std::vector<std::string> items{"5 97 %", "6 90 %", "3 60 %"};
  EXPECT_EQ(listed("worst: ", items, ", ", 40),
            "worst: 5 97 %, 6 90 %, 3 60 %");
  EXPECT_EQ(listed("worst: ", items, ", ", 28), "worst: 5 97 %, 6 90 %, +1");
  EXPECT_EQ(listed("worst: ", items, ", ", 17), "worst: 5 97 %, +2");
  EXPECT_EQ(listed("worst: ", items, ", ", 10), "worst: +3");
  EXPECT_EQ(listed("worst: ", {}, ", ", 10), "worst: ");
}

}  // namespace
}  // namespace tapfit::tui
