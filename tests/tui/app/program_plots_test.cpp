// P and y: what a screen plots is written under free names, or copied.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/tui/support/play.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

class Plots : public ::testing::Test {
 protected:
  [[nodiscard]] std::string written_on(int screen,
                                       const std::string& keys = "") const {
    return played(fmt::format("{}\nwait\n{}\n:plot {}/p<Enter>",
                              screen,
                              keys,
                              folder_.path().string()),
                  {300, 60});
  }
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& file : fs::directory_iterator(folder_.path())) {
      found.insert(file.path().filename().string());
    }
    return found;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(folder_.path() / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  ::tapfit::testing::TemporaryFolder folder_;
};

// The curves are those of the made-up FRFs: 157 lines from 1 to 40 Hz.
TEST_F(Plots, AreWrittenAsPicturesAndTables) {
  const std::string seen = written_on(2);
  EXPECT_TRUE(holds(seen, "written: ")) << seen;
  EXPECT_EQ(names(),
            (std::set<std::string>{"p-a.csv", "p-a.svg", "p-b.csv", "p-b.svg"}))
      << seen;
  const std::string table = read("p-a.csv");
  EXPECT_TRUE(table.starts_with("f [Hz],")) << table;
  EXPECT_EQ(std::ranges::count(table, '\n'), 158) << table;
  EXPECT_TRUE(holds(table, "\n40,")) << table;
  EXPECT_TRUE(read("p-a.svg").starts_with("<svg"));
}

// 2560 samples of the made-up record at its rate, hits of 20 N at 256, 1024 and
// 1792, whatever the terminal's width.
TEST_F(Plots, OfARecordingHoldItsSamples) {
  std::string first;
  for (const int width : {90, 300}) {
    const std::string name = fmt::format("w{}", width);
    const std::string seen = played(
        fmt::format(
            "1\nwait\n:plot {}/{}<Enter>", folder_.path().string(), name),
        {width, 60});
    const std::string table = read(name + "-a.csv");
    EXPECT_EQ(std::ranges::count(table, '\n'), 2561) << seen;
    EXPECT_TRUE(holds(table, "\n1,20\n")) << table.substr(0, 200);
    if (first.empty()) first = table;
    EXPECT_EQ(table, first);
  }
}

TEST_F(Plots, OfModesNameWhatTheyHold) {
  const std::string seen = written_on(3);
  std::string tables;
  for (const std::string& name : names()) {
    if (name.ends_with(".csv")) tables += read(name);
  }
  for (const char* heading : {"CMIF 1 [(m/s²)/N]",
                              "stable pole f [Hz]",
                              "grid,x [m],y [m],z [m]",
                              "measured z"}) {
    EXPECT_TRUE(holds(tables, heading)) << heading << "\n" << seen;
  }
  EXPECT_FALSE(holds(tables, "order 2")) << tables;
}

TEST_F(Plots, OfTheStructureHaveWhatItsMarksStandFor) {
  EXPECT_TRUE(holds(written_on(4), "written: "));
  EXPECT_TRUE(holds(written_on(5, "m\nwait"), "written: "));
  std::string tables;
  for (const std::string& name : names()) {
    if (name.ends_with(".csv")) tables += read(name);
  }
  EXPECT_TRUE(holds(tables, "grid,x [m],y [m],z [m],error [%]")) << tables;
  EXPECT_TRUE(holds(tables, "z [m],explains alone [%]")) << tables;
}

TEST_F(Plots, AreNeverWrittenOver) {
  folder_.write("p-b.csv", "mine");
  const std::string seen = written_on(2);
  EXPECT_TRUE(holds(seen, "p-2-a.svg")) << seen;
  EXPECT_EQ(read("p-b.csv"), "mine");
  EXPECT_EQ(names().size(), 5U) << seen;
}

TEST_F(Plots, AreThereOnEveryScreen) {
  for (int screen = 1; screen <= 7; ++screen) {
    const auto before = names().size();
    const std::string seen = written_on(screen);
    EXPECT_GT(names().size(), before) << screen << seen;
  }
}

TEST_F(Plots, KeepThePointsOfTheirNames) {
  const std::string seen = played(
      fmt::format("2\nwait\n:plot {}/p.v2<Enter>", folder_.path().string()),
      {300, 60});
  EXPECT_TRUE(names().contains("p.v2-a.svg")) << seen;
}

// What is not there yet is named, not denied.
TEST(PlotsToCome, AreSaidToBeWorkedOut) {
  Program program(testing::fake_workbench(), {300, 60});
  program.press(U'1');
  wait_until_idle(program);
  for (const char32_t key : {U'P', U'y'}) {
    program.press(U'2');
    program.press(key);
    const std::string seen = program.draw().to_text();
    EXPECT_TRUE(holds(seen, "nothing is plotted yet: still working out FRFs"))
        << seen;
  }
}

TEST_F(Plots, ThatCannotBeWrittenAreSaid) {
  const std::string seen =
      played("2\nwait\n:plot /nowhere/at/all/p<Enter>", {300, 60});
  EXPECT_TRUE(holds(seen, "/nowhere/at/all")) << seen;
  EXPECT_FALSE(holds(seen, "written")) << seen;
}

/// What is copied on a screen, and what is told of it.
std::pair<std::string, std::string> copied_on(char32_t screen,
                                              const std::string& keys) {
  Program program(testing::fake_workbench(), {300, 60});
  std::string copied;
  program.copy_with([&copied](const std::string& text) { copied = text; });
  program.press(Key(screen));
  wait_until_idle(program);
  for (const char key : keys) program.press(Key(static_cast<char32_t>(key)));
  return {copied, program.draw().to_text()};
}

TEST(CopiedPlot, HasTabsBetweenItsColumns) {
  const auto [copied, seen] = copied_on(U'2', "y");
  EXPECT_TRUE(copied.starts_with("f [Hz]\t")) << copied;
  const auto lines = std::ranges::count(copied, '\n');
  EXPECT_TRUE(holds(seen, fmt::format("copied {} lines", lines))) << seen;
}

TEST(CopiedPlot, NeedsATerminal) {
  const std::string seen = played("2\nwait\ny");
  EXPECT_TRUE(holds(seen, "y copies in a terminal")) << seen;
}

// There it replaces the file.
TEST(CopiedPlot, StaysAnAnswer) {
  ::tapfit::testing::TemporaryFolder folder;
  const auto file = folder.write("r.md", "older");
  Program program(testing::fake_workbench(), {300, 60});
  bool copied = false;
  program.copy_with([&copied](const std::string&) { copied = true; });
  (void)replay(program,
               parse_key_script(fmt::format(
                   "2\nwait\n:report {}<Enter>\ny\nwait", file.string())));
  EXPECT_FALSE(copied);
}

}  // namespace
}  // namespace tapfit::tui
