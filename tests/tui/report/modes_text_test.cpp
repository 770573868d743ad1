#include "tui/report/modes_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace tapfit::tui {
namespace {

modal::ModeSet sample_modes() {
  modal::Mode mode;
  mode.frequency_hz = 2.271;
  mode.frequency_sd_hz = 0.0004;
  mode.damping_ratio = 0.0044;
  mode.damping_sd = 0.0001;
  mode.mpc = 0.998;
  mode.mpd_deg = 4.5;
  mode.cluster = {60, 2.27, 0.001, 0.0045, 0.0002};
  mode.shape = Eigen::VectorXcd::Constant(1, {0.5, -0.25});
  modal::ModeSet set;
  set.dofs = {{.node = 12, .component = 3, .sign = 1}};
  set.modes = {mode};
  set.warnings = {"one is weak"};
  return set;
}

TEST(ModesText, JsonIsThatOfTheFormat) {
  auto json = modes_json(sample_modes());
  auto& real = json.at("modes").at(0).at("real_shape");
  EXPECT_NEAR(real.at("12Z+").get<double>(), std::hypot(0.5, 0.25), 1e-15);
  real["12Z+"] = 0.0;
  EXPECT_EQ(json.at("modes").dump(),
            R"([{"frequency_hz":{"value":2.271,"sd":0.0004},)"
            R"("damping_ratio":{"value":0.0044,"sd":0.0001},"mpc":0.998,)"
            R"("mpd_deg":4.5,"cluster":{"poles":60,)"
            R"("frequency_hz":{"mean":2.27,"scatter":0.001},)"
            R"("damping_ratio":{"mean":0.0045,"scatter":0.0002}},)"
            R"("shape":{"12Z+":[0.5,-0.25]},"real_shape":{"12Z+":0.0}}])");
  EXPECT_EQ(json.at("warnings").dump(), R"(["one is weak"])");
  modal::ModeSet by_hand = sample_modes();
  by_hand.modes[0].cluster = {};
  EXPECT_TRUE(modes_json(by_hand).at("modes").at(0).at("cluster").is_null());
}

// Frequencies alone, as somebody else's report has them.
TEST(ModesText, TellsNothingThatWasNotGiven) {
  modal::ModeSet set;
  set.modes.resize(1);
  set.modes[0].frequency_hz = 7.94;
  set.modes[0].frequency_sd_hz = 0.024;
  const auto json = modes_json(set);
  const auto& mode = json.at("modes").at(0);
  EXPECT_TRUE(mode.at("damping_ratio").at("value").is_null());
  EXPECT_TRUE(mode.at("damping_ratio").at("sd").is_null());
  EXPECT_TRUE(mode.at("mpc").is_null());
  EXPECT_TRUE(mode.at("mpd_deg").is_null());
  EXPECT_TRUE(json.at("synthesis_error").is_null());
  EXPECT_TRUE(json.at("unrefined_error").is_null());
  const std::string text = modes_text(set);
  EXPECT_EQ(text.find("0.000"), std::string::npos) << text;
  EXPECT_EQ(text.find(" 0 "), std::string::npos) << text;
}

TEST(ModesText, GivesTheMassThatMovesThePoles) {
  modal::ModeSet modes = sample_modes();
  EXPECT_FALSE(modes_json(modes).contains("pole_shifts"));
  modes.shifts = modal::PoleShifts{};
  EXPECT_EQ(modes_json(modes).at("pole_shifts").at("cause"), "none");
  EXPECT_EQ(modes_text(modes).find("frequencies move"), std::string::npos);
  modes.shifts->cause = modal::ShiftCause::SensorMass;
  modes.shifts->masses = {{0.02, 0.001, 0.018, 0.022}};
  modes.shifts->sensors = {{1}, {2}};
  const std::vector<std::string> channels{"hammer", "acc1", "acc2"};
  const auto json = modes_json(modes, channels).at("pole_shifts");
  EXPECT_EQ(json.at("cause"), "sensor-mass");
  EXPECT_EQ(json.at("masses").dump(),
            R"([{"channels":["acc1","acc2"],"mass_kg":{"value":0.02,)"
            R"("sd":0.001,"lo95":0.018,"hi95":0.022}}])");
  EXPECT_NE(modes_text(modes, channels).find("20 g (95 %: 18 to 22 g) each"),
            std::string::npos);
}

TEST(ModesText, TextHasFrequencyDampingAndWarnings) {
  const std::string text = modes_text(sample_modes());
  EXPECT_NE(text.find("2.27100 ± 0.00040"), std::string::npos) << text;
  EXPECT_NE(text.find("0.440 ± 0.010"), std::string::npos) << text;
  EXPECT_NE(text.find("one is weak"), std::string::npos) << text;
}

}  // namespace
}  // namespace tapfit::tui
