#include "tui/commands/compare_command.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

signal::FrfSet two_runs_of_one_pair() {
  signal::Frf frf;
  frf.response = {.node = 12, .component = 3, .sign = 1};
  frf.reference = {.node = 3, .component = 3, .sign = 1};
  signal::FrfSet set;
  set.frfs = {frf, frf};
  set.frfs[1].run = 1;
  return set;
}

updating::Comparison sample_comparison() {
  updating::Comparison comparison;
  comparison.error = 0.39;
  comparison.floor = 0.03;
  comparison.contour = "s = 0.8 + j omega";
  comparison.pairs = {{.measured = 0,
                       .model = 0,
                       .measured_hz = 2.17,
                       .model_hz = 2.27,
                       .error_percent = 4.6,
                       .mac = 0.997,
                       .weighted_mac = 0.998}};
  comparison.frf_error = {0.2, 0.5};
  comparison.frac = {0.75, 0.5};
  comparison.point_error = {{12, 0.43}};
  return comparison;
}

TEST(CompareCommand, JsonHasThePromisedFields) {
  const auto json = compare_json(sample_comparison(), two_runs_of_one_pair());
  EXPECT_EQ(json.at("error").at("base"), 0.39);
  EXPECT_EQ(json.at("error").at("floor"), 0.03);
  EXPECT_EQ(json.at("pairs").dump(),
            R"([{"measured_hz":2.17,"model_hz":2.27,"error_percent":4.6,)"
            R"("mac":0.997,"weighted_mac":0.998,"by_hand":false}])");
  EXPECT_EQ(json.at("points").dump(), R"({"12":0.43})");
}

TEST(CompareCommand, JsonLeadsToFrfsBandsAndPoints) {
  updating::Comparison comparison = sample_comparison();
  comparison.bands = {{1.0, 10.0, 0.3}};
  comparison.comac = Eigen::Vector2d(0.9, 0.8);
  const std::vector<Dof> dofs{{12, 3, 1}, {3, 3, 1}};
  const auto json = compare_json(comparison, two_runs_of_one_pair(), dofs);
  EXPECT_EQ(json.at("frf_error").dump(), R"({"12Z+ / 3Z+":0.5})");
  EXPECT_EQ(json.at("bands").dump(),
            R"([{"low_hz":1.0,"high_hz":10.0,"error":0.3}])");
  EXPECT_EQ(json.at("comac").dump(), R"({"12Z+":0.9,"3Z+":0.8})");
  const std::string text =
      compare_text(comparison, two_runs_of_one_pair(), dofs);
  EXPECT_NE(text.find("CoMAC at worst 0.800 at 3Z+, 0.900 at 12Z+"),
            std::string::npos)
      << text;
}

TEST(CompareCommand, FracOfAPairMeasuredTwiceIsTheWorse) {
  const auto json = compare_json(sample_comparison(), two_runs_of_one_pair());
  EXPECT_EQ(json.at("frac").dump(), R"({"12Z+ / 3Z+":0.5})");
}

TEST(CompareCommand, TextListsTheWorstFrfFirst) {
  const std::string text =
      compare_text(sample_comparison(), two_runs_of_one_pair());
  EXPECT_NE(text.find("error 39.0 %, floor 3.0 %"), std::string::npos) << text;
  const std::size_t worst = text.find("50.0 %");
  const std::size_t better = text.find("20.0 %");
  ASSERT_NE(worst, std::string::npos) << text;
  ASSERT_NE(better, std::string::npos) << text;
  EXPECT_LT(worst, better);
}

TEST(CompareCommand, TextOfManyFrfsStopsAtTheFiveWorst) {
  auto comparison = sample_comparison();
  auto frfs = two_runs_of_one_pair();
  comparison.frf_error = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  comparison.frac.assign(7, 0.9);
  frfs.frfs.assign(7, frfs.frfs[0]);
  const std::string text = compare_text(comparison, frfs);
  EXPECT_NE(text.find("70.0 %"), std::string::npos) << text;
  EXPECT_NE(text.find("30.0 %"), std::string::npos) << text;
  EXPECT_EQ(text.find("20.0 %"), std::string::npos) << text;
}

TEST(CompareCommand, TextOfNothingIsNoFault) {
  EXPECT_NO_THROW((void)compare_text({}, {}));
}

}  // namespace
}  // namespace tapfit::tui
