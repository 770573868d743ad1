// What is said of where the program runs.
#include "tui/commands/doctor_command.hpp"

#include "tui/commands/commands.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tapfit::tui {
namespace {

Surroundings healthy() {
  Surroundings here;
  here.terminal = {true, "xterm-256color", true, true, 256, true, 120, 35, {}};
  here.utf8 = true;
  here.locale = "C.UTF-8";
  here.cache = "/home/somebody/.cache/tapfit";
  here.cache_writable = true;
  here.cache_bytes = 12'000'000;
  here.memory_bytes = 16e9;
  here.free_bytes = 12e9;
  here.threads = 8;
  return here;
}

HealthCheck check_of(const Surroundings& here, const std::string& name) {
  const std::vector<HealthCheck> checks = health_checks(here, {});
  const auto found = std::ranges::find(checks, name, &HealthCheck::name);
  if (found != checks.end()) return *found;
  ADD_FAILURE() << name;
  return {};
}

TEST(Doctor, HasNoAdviceWhereAllIsWell) {
  const std::vector<HealthCheck> checks = health_checks(healthy(), {});
  EXPECT_EQ(checks.size(), 11U);
  for (const HealthCheck& check : checks) {
    EXPECT_EQ(check.advice, "") << check.name;
    EXPECT_NE(check.found, "") << check.name;
    EXPECT_NE(check.meaning, "") << check.name;
  }
  EXPECT_EQ(check_of(healthy(), "cache").found,
            "/home/somebody/.cache/tapfit, 12 MB");
  EXPECT_EQ(check_of(healthy(), "memory").found, "12.0 GB of 16.0 GB free");
}

TEST(Doctor, SaysWhatCurvesAreDrawnIn) {
  Surroundings here = healthy();
  EXPECT_EQ(check_of(here, "graphics").found, "none");
  here.terminal.graphics.sixel = true;
  here.terminal.graphics.cell = {10, 20};
  EXPECT_EQ(check_of(here, "graphics").found,
            "sixels, cells of 10 x 20 pixels");
  here.terminal.graphics.kitty = true;
  EXPECT_EQ(check_of(here, "graphics").found,
            "kitty's protocol, cells of 10 x 20 pixels");
}

TEST(Doctor, NamesTheFileOfSettingsAndWhatIsWrongThere) {
  const auto check = [](const Settings& settings) {
    const std::vector<HealthCheck> checks = health_checks(healthy(), settings);
    return *std::ranges::find(checks, "settings", &HealthCheck::name);
  };
  EXPECT_EQ(check({}).found, "none");
  EXPECT_EQ(check({}).advice, "");
  Settings settings;
  settings.file = "/home/somebody/.config/tapfit/config.json";
  EXPECT_EQ(check(settings).found, settings.file->string());
  EXPECT_EQ(check(settings).advice, "");
  settings.faults = {"theme is \"dark\"", "keys: q"};
  EXPECT_EQ(check(settings).advice, "theme is \"dark\"; keys: q");
}

TEST(Doctor, SaysWhatToDo) {
  Surroundings here = healthy();
  here.terminal.width = 60;
  here.terminal.colours = 8;
  here.terminal.mouse = false;
  here.utf8 = false;
  here.locale = "C";
  here.in_tmux = true;
  here.cache_writable = false;
  here.free_bytes = 3e8;
  here.threads = 1;
  const std::vector<HealthCheck> checks = health_checks(here, {});
  EXPECT_EQ(std::ranges::count(checks, "", &HealthCheck::advice), 3);
  EXPECT_EQ(check_of(here, "terminal").advice, "");
  EXPECT_EQ(check_of(here, "size").found, "60 x 35 cells");
  EXPECT_NE(check_of(here, "locale").advice.find("C.UTF-8"), std::string::npos);
  EXPECT_NE(check_of(here, "memory").advice.find("tapfit replay"),
            std::string::npos);
}

TEST(Doctor, KnowsWhatIsNoTerminal) {
  Surroundings here = healthy();
  here.terminal = {};
  here.cache.reset();
  EXPECT_NE(check_of(here, "terminal").advice, "");
  EXPECT_EQ(check_of(here, "size").found, "not known");
  EXPECT_NE(check_of(here, "cache").advice.find("TAPFIT_NO_CACHE"),
            std::string::npos);
  here = healthy();
  here.terminal.places_cursor = false;
  EXPECT_NE(check_of(here, "terminal").advice.find("vt100"), std::string::npos);
  here.no_colour = true;
  EXPECT_NE(check_of(here, "colours").advice, "");
}

// Of the machine that the tests run on.
TEST(Doctor, PrintsTextAndJson) {
  CommandOptions options;
  const std::string text = doctor_command(options, {});
  for (const char* word :
       {"terminal", "colours", "memory", "threads", "FFTW"}) {
    EXPECT_NE(text.find(word), std::string::npos) << text;
  }
  options.json = true;
  const auto json = nlohmann::json::parse(doctor_command(options, {}));
  EXPECT_EQ(json["checks"].size(), 11U);
  for (const auto& check : json["checks"]) {
    EXPECT_EQ(check["ok"], check["advice"] == "") << check;
  }
  EXPECT_TRUE(json["libraries"].contains("tapfit"));
  const Surroundings here = look_around();
  EXPECT_GE(here.memory_bytes, here.free_bytes);
  EXPECT_GT(here.free_bytes, 0.0);
  EXPECT_GE(here.threads, 1U);
}

}  // namespace
}  // namespace tapfit::tui
