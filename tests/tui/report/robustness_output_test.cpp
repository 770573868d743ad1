#include "tui/report/robustness_output.hpp"

#include "tests/tui/support/fake_results.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

using testing::fake_robustness;

TEST(RobustnessOutput, CountsWhatStandsAndTellsTheFarthestMove) {
  RobustnessRows rows = fake_robustness();
  EXPECT_EQ(firmness_words(rows),
            "the verdict stands under 1 of 2 changes; sizes move by up to 1.2 "
            "standard deviations (runs 1 to 2 left out)");
  rows.pop_back();
  EXPECT_EQ(firmness_words(rows),
            "the verdict stands under all 1 changes; sizes move by up to 0.5 "
            "standard deviations (prior of E:1 doubled)");
  rows[0].parameters.clear();
  EXPECT_EQ(firmness_words(rows), "the verdict stands under all 1 changes");
  EXPECT_EQ(move_text(rows[0]), "");
}

TEST(RobustnessOutput, TableHasALineForEachChange) {
  const std::vector<std::string> lines = robustness_table(fake_robustness());
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1],
            "  prior of E:1 doubled  stands    0.50 sd  mass_kg 0.0788");
  EXPECT_EQ(lines[2],
            "  runs 1 to 2 left out  none      1.25 sd  mass_kg 0.0788");
}

TEST(RobustnessOutput, JsonHasTheFieldsOfTheFormat) {
  const auto json = robustness_json(fake_robustness());
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[1]["change"], "runs 1 to 2 left out");
  EXPECT_EQ(json[1]["verdict"], "none");
  EXPECT_EQ(json[1]["verdict_stands"], false);
  EXPECT_EQ(json[1]["largest_move_sd"], 1.25);
  EXPECT_EQ(json[1]["parameters"]["added-mass mass_kg"]["value"], 0.0788);
}

}  // namespace
}  // namespace tapfit::tui
