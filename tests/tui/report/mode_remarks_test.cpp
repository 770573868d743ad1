#include "tui/report/mode_remarks.hpp"

#include "tests/tui/support/fake_results.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(ModeRemarks, TellCloseModesFromThoseThatAreOff) {
  updating::Comparison c = testing::fake_comparison(0.0);
  c.error = 0.011;
  c.floor = 0.013;
  c.pairs = {{0, 0, 76.46, 76.07, -0.5, 0.997},
             {1, 1, 316.97, 324.55, 2.39, 0.958},
             {2, 2, 504.41, 504.34, -0.01, 0.604},
             {3, 3, 505.39, 498.56, -1.35, 0.356}};
  const std::vector<std::string> remarks = mode_remarks(c);
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[0].substr(0, 36), "504.4 and 505.4 Hz are 0.19 % apart:");
  EXPECT_NE(remarks[1].find("the measurement supports: 317 Hz."),
            std::string::npos)
      << remarks[1];
}

TEST(ModeRemarks, AreNoneWhereAllFitsOrTheErrorIsWhatIsOff) {
  updating::Comparison c = testing::fake_comparison(0.0);
  c.pairs = {{0, 0, 76.46, 76.07, -0.5, 0.997}};
  EXPECT_TRUE(mode_remarks(c).empty());
  c.pairs[0].mac = 0.3;
  EXPECT_EQ(mode_remarks(c).size(), 1U);
  c.error = 2.0 * c.floor;
  EXPECT_TRUE(mode_remarks(c).empty());
}

}  // namespace
}  // namespace tapfit::tui
