#include "tui/commands/mac_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/read_modes_file.hpp"
#include "modal/mode_set/read_modes_json.hpp"
#include "tui/commands/commands.hpp"
#include "tui/report/modes_text.hpp"
#include "tui/workbench/pair_words.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace tapfit::tui {
namespace {

/// Two half sines over twenty points, the second mode twice as high.
modal::ModeSet bar(double first_hz) {
  modal::ModeSet set;
  for (int node = 1; node <= 20; ++node) set.dofs.push_back({node, 3, 1});
  for (int m = 1; m <= 2; ++m) {
    modal::Mode mode;
    mode.frequency_hz = first_hz * m;
    mode.damping_ratio = 0.01;
    mode.shape.resize(20);
    for (int k = 0; k < 20; ++k) {
      mode.shape(k) = std::sin(m * std::numbers::pi * (k + 1) / 21.0);
    }
    mode.shape_sd = Eigen::VectorXd::Constant(20, 0.01);
    set.modes.push_back(mode);
  }
  return set;
}

TEST(MacCommand, PairsModesAndNamesTheSensorThatIsOff) {
  modal::ModeSet other = bar(10.5);
  for (modal::Mode& mode : other.modes) mode.shape(12) *= -1.0;
  const auto json = mac_json(bar(10.0), other, {});
  EXPECT_EQ(json.at("points"), 20);
  ASSERT_EQ(json.at("pairs").size(), 2U);
  EXPECT_NEAR(json.at("pairs")[0].at("error_percent"), 5.0, 1e-9);
  EXPECT_LT(json.at("pairs")[0].at("mac").at("value"), 0.9);
  EXPECT_GT(json.at("pairs")[0].at("mac").at("sd"), 0.0);
  EXPECT_EQ(json.at("macco")[0].at("left_out"), "13Z+");
  EXPECT_NEAR(json.at("macco")[0].at("mean_mac"), 1.0, 1e-12);
  EXPECT_NE(mac_text(bar(10.0), other, {}).find("13Z+"), std::string::npos);
}

TEST(MacCommand, TakesPairsByHand) {
  EXPECT_FALSE(parse_pair("2"));
  EXPECT_FALSE(parse_pair("0:1"));
  EXPECT_FALSE(parse_pair("1:x"));
  const auto pair = parse_pair("1:none");
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->model, -1);
  const auto json = mac_json(bar(10.0), bar(10.0), {*parse_pair("1:2")});
  ASSERT_EQ(json.at("pairs").size(), 1U);
  EXPECT_EQ(json.at("pairs")[0].at("second"), 2);
}

TEST(MacCommand, SaysWhereTheUncertaintyIsUnknown) {
  modal::ModeSet first = bar(10.0);
  for (modal::Mode& mode : first.modes) mode.shape_sd.resize(0);
  const auto json = mac_json(first, bar(10.0), {});
  ASSERT_EQ(json.at("pairs").size(), 2U);
  EXPECT_NEAR(json.at("pairs")[0].at("mac").at("value"), 1.0, 1e-12);
  EXPECT_TRUE(json.at("pairs")[0].at("mac").at("sd").is_null());
  EXPECT_NE(mac_text(first, bar(10.0), {}).find("unknown"), std::string::npos);
}

TEST(MacCommand, SaysThatNothingPairs) {
  const std::string text = mac_text(
      bar(10.0), bar(10.0), {*parse_pair("1:none"), *parse_pair("2:none")});
  EXPECT_NE(text.find("none"), std::string::npos) << text;
}

TEST(MacCommand, RefusesSetsWithoutACommonPoint) {
  modal::ModeSet other = bar(10.0);
  for (Dof& dof : other.dofs) dof.node += 100;
  EXPECT_THROW((void)mac_json(bar(10.0), other, {}), InputError);
}

TEST(ModesFile, JsonOfTheModesComesBack) {
  modal::ModeSet written = bar(10.0);
  written.modes[0].damping_ratio = 0.0;  // not known: null
  const modal::ModeSet read =
      modal::read_modes_json(modes_json(written).dump(), "memory");
  ASSERT_EQ(read.modes.size(), 2U);
  EXPECT_EQ(read.dofs, written.dofs);
  EXPECT_EQ(read.modes[0].damping_ratio, 0.0);
  EXPECT_EQ(read.modes[1].damping_ratio, written.modes[1].damping_ratio);
  EXPECT_EQ(read.modes[1].frequency_hz, written.modes[1].frequency_hz);
  EXPECT_EQ(read.modes[1].shape, written.modes[1].shape);
  EXPECT_EQ(read.modes[1].shape_sd, written.modes[1].shape_sd);
}

TEST(ModesFile, SaysWhatIsNoJsonOfModes) {
  EXPECT_THROW((void)modal::read_modes_json("{", "m"), InputError);
  EXPECT_THROW((void)modal::read_modes_json(R"({"modes": []})", "m"),
               InputError);
  EXPECT_THROW((void)modal::read_modes_json(
                   R"({"modes": [{"shape": {"a": [1, 0]}}]})", "m"),
               InputError);
  EXPECT_THROW((void)modal::read_modes_file("/nonexistent.json"), InputError);
  EXPECT_THROW((void)modal::read_modes_file(testing::TempDir()), InputError);
}

}  // namespace
}  // namespace tapfit::tui
