// The user's file of settings, and what the program makes of it.
#include "tui/app/settings.hpp"

#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

class SettingsFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() /
            (std::string("tapfit_settings_") + test->name());
    fs::remove_all(root_);
    fs::create_directories(root_ / "tapfit");
    for (const char* name : {"XDG_CONFIG_HOME", "HOME"}) {
      const char* value = std::getenv(name);
      before_.emplace_back(name, value == nullptr ? "" : value);
    }
    ::setenv("XDG_CONFIG_HOME", root_.c_str(), 1);
  }
  void TearDown() override {
    for (const auto& [name, value] : before_) {
      value.empty() ? ::unsetenv(name.c_str())
                    : ::setenv(name.c_str(), value.c_str(), 1);
    }
    fs::remove_all(root_);
  }

  Settings read(const std::string& text) {
    std::ofstream(root_ / "tapfit/config.json") << text;
    return read_settings(settings_file());
  }
  std::string faults(const std::string& text) {
    return fault_words(read(text));
  }

  fs::path root_;
  std::vector<std::pair<std::string, std::string>> before_;
};

TEST_F(SettingsFile, IsWhereOthersKeepTheirs) {
  EXPECT_EQ(settings_file(), root_ / "tapfit/config.json");
  ::setenv("XDG_CONFIG_HOME", "relative", 1);
  ::setenv("HOME", root_.c_str(), 1);
  EXPECT_EQ(settings_file(), root_ / ".config/tapfit/config.json");
  ::unsetenv("XDG_CONFIG_HOME");
  ::unsetenv("HOME");
  EXPECT_FALSE(settings_file().has_value());
}

TEST_F(SettingsFile, MayBeMissing) {
  const Settings settings = read_settings(settings_file());
  EXPECT_FALSE(settings.file.has_value());
  EXPECT_TRUE(settings.faults.empty());
  EXPECT_EQ(settings.theme, Theme::Default);
  EXPECT_FALSE(read_settings(std::nullopt).file.has_value());
}

TEST_F(SettingsFile, SaysColoursAxesAndKeys) {
  const Settings settings = read(R"({"theme": "high-contrast",
    "background": "light", "magnitude": "dB", "frequency": "logarithmic",
    "graphics": "off", "keys": {"F": "plot", "<C-b>": "band 10 60"}})");
  EXPECT_EQ(fault_words(settings), "");
  EXPECT_EQ(settings.file, settings_file());
  EXPECT_EQ(settings.theme, Theme::HighContrast);
  EXPECT_EQ(settings.light, true);
  EXPECT_EQ(settings.graphics, GraphicsWish::Off);
  EXPECT_EQ(settings.magnitude, MagnitudeScale::Decibels);
  EXPECT_TRUE(settings.log_frequency);
  ASSERT_EQ(settings.keys.size(), 2U);
  EXPECT_EQ(binding_of(settings.keys, Key(U'F'))->command, "plot");
  EXPECT_EQ(binding_of(settings.keys, Key(U'b', true))->command, "band 10 60");
}

TEST_F(SettingsFile, SaysWhatIsAllowedAndKeepsTheRest) {
  const std::string text = R"({"theme": "high-contrats", "colour": 1,
    "magnitude": 3, "frequency": "logarithmic",
    "keys": {"q": "plot", "<F99>": "plot", "F": "reprot", "G": 7,
             "H": "report"}})";
  const std::string told = faults(text);
  EXPECT_TRUE(holds(told,
                    "theme is \"high-contrats\": did you mean high-contrast? "
                    "write default, high-contrast, mono"))
      << told;
  EXPECT_TRUE(holds(told,
                    "colour is no setting: there are theme, background, "
                    "graphics"))
      << told;
  EXPECT_TRUE(holds(told, "magnitude is 3: write logarithmic, linear, dB"))
      << told;
  EXPECT_TRUE(holds(told, "keys: q is always what it is")) << told;
  EXPECT_TRUE(holds(told, "keys: <F99> is no key")) << told;
  EXPECT_TRUE(holds(told, "keys: F ")) << told;
  EXPECT_TRUE(holds(told, "did you mean :report?")) << told;
  EXPECT_TRUE(holds(told, "keys: G needs a command")) << told;
  const Settings settings = read(text);
  EXPECT_EQ(settings.theme, Theme::Default);
  EXPECT_TRUE(settings.log_frequency);
  ASSERT_EQ(settings.keys.size(), 1U);
  EXPECT_EQ(settings.keys.front().command, "report");
}

TEST_F(SettingsFile, MayBeNoSettingsAtAll) {
  const std::string torn = faults("{\n  \"theme\": ");
  EXPECT_TRUE(holds(torn, "config.json:2:12")) << torn;
  EXPECT_FALSE(holds(torn, "exception")) << torn;
  EXPECT_TRUE(holds(faults("[1]"), "holds no settings"));
  EXPECT_TRUE(holds(faults(R"({"keys": 3})"), "write a table of keys"));
  fs::remove(root_ / "tapfit/config.json");
  fs::create_directory(root_ / "tapfit/config.json");
  EXPECT_FALSE(read_settings(settings_file()).faults.empty());
}

std::string played_with(const Settings& settings,
                        const std::string& script,
                        const Canvas& canvas = {120, 35, false}) {
  Program program(testing::fake_workbench(), canvas, settings);
  return replay(program, parse_key_script(script));
}

TEST_F(SettingsFile, BeginsPlotsAsSet) {
  const Settings settings = read(R"({"magnitude": "dB"})");
  EXPECT_TRUE(holds(played_with(settings, "2\nwait"), "dB re 1"));
  EXPECT_TRUE(holds(played_with(settings, "4\nwait"), "dB re 1"));
  EXPECT_TRUE(holds(played_with(settings, "6\nwait"), "dB re 1"));
  EXPECT_FALSE(holds(played_with({}, "2\nwait"), "dB re 1"));
}

TEST_F(SettingsFile, BindsKeysToCommandsOnEveryScreen) {
  const Settings settings =
      read(R"({"keys": {"F": "tour", "<C-b>": "run 2", "j": "screen 3"}})");
  EXPECT_TRUE(holds(played_with(settings, "1\nwait\nF"), "1 of 7."));
  EXPECT_TRUE(
      holds(played_with(settings, "1\nwait\n<C-b>\nwait"), "run 2 of 2"));
  // Before the screen's own.
  const std::string own = played_with(settings, "2\nwait\nj\nwait");
  EXPECT_TRUE(holds(own, "stabilisation")) << own;
  // Typed, it is a letter.
  EXPECT_TRUE(holds(played_with(settings, "2\nwait\n/F"), "\n/F"));
  // The palette and the help know it.
  EXPECT_TRUE(holds(played_with(settings, "1\nwait\n:tour"), "and off"));
  const std::string palette = played_with(settings, "1\nwait\n:");
  EXPECT_TRUE(holds(palette, " F │")) << palette;
  EXPECT_TRUE(holds(palette, " u │")) << palette;
  const std::string help = played_with(settings, "1\nwait\n?");
  EXPECT_TRUE(holds(help, "^B     run 2")) << help;
}

TEST_F(SettingsFile, FaultsAreToldAndTheWorkGoesOn) {
  const Settings settings = read(R"({"theme": "dark"})");
  const std::string told = played_with(settings, "wait");
  EXPECT_TRUE(holds(told, "theme is \"dark\"")) << told;
  EXPECT_TRUE(holds(played_with(settings, "wait\nj"), "run-01.wav"));
}

}  // namespace
}  // namespace tapfit::tui
