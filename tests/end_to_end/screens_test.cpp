#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace tapfit::end_to_end {
namespace {

// All seven screens of the program itself, on a small virtual test.
TEST(Screens, KeysWalkFromRecordingToReport) {
  const std::filesystem::path folder = fresh_folder();
  const std::filesystem::path bundle = folder / "ladder";
  const auto made = run_tapfit(
      fmt::format("simulate '{}' --structure ladder --seed 5 --runs 6 --hits 3 "
                  "--effect added-mass@200=0.05",
                  bundle.string()));
  ASSERT_EQ(made.exit_status, 0) << made.err;
  std::string script;
  for (const char* key : {"1", "2", "3", "4", "5", "a", "6", "7", "u"}) {
    script += fmt::format("{}\nwait\nscreen\n", key);
  }
  write_file(folder / "keys.txt", script);
  const auto seen = run_tapfit(fmt::format(
      "'{}' --keys '{}'", bundle.string(), (folder / "keys.txt").string()));
  ASSERT_EQ(seen.exit_status, 0) << seen.err;
  for (const char* words : {"run 1 of 6",
                            "|H| [(m/s",
                            "MAC",
                            "measured Hz",
                            "verdict: added-mass",
                            "added-mass at node 200",
                            "Verdict",
                            "undone"}) {
    EXPECT_NE(seen.out.find(words), std::string::npos) << words;
  }
}

// What was undone is done again after the program was left and started anew,
// and the report that a key writes is the one that the command line writes.
TEST(Screens, WorkOutlivesTheProgram) {
  const std::filesystem::path folder = fresh_folder();
  const std::filesystem::path bundle = folder / "ladder";
  const auto made = run_tapfit(
      fmt::format("simulate '{}' --structure ladder --seed 5 --runs 6 --hits 3 "
                  "--effect added-mass@200=0.05",
                  bundle.string()));
  ASSERT_EQ(made.exit_status, 0) << made.err;
  const auto replay = [&](const std::string& keys) {
    write_file(folder / "keys.txt", keys);
    const auto seen = run_tapfit(fmt::format(
        "'{}' --keys '{}'", bundle.string(), (folder / "keys.txt").string()));
    EXPECT_EQ(seen.exit_status, 0) << seen.err;
    return seen.out;
  };
  const auto holds = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string undone =
      replay("6\nwait\n:add added-mass@200<Enter>\nwait\nu\nwait\n");
  EXPECT_TRUE(holds(undone, "undone")) << undone;
  const std::string redone = replay("6\nwait\n<C-r>\nwait\n");
  EXPECT_TRUE(holds(redone, "1 effect added: error")) << redone;
  const std::string there = replay("6\nwait\n");
  EXPECT_TRUE(holds(there, "1 effect added: error")) << there;
  EXPECT_TRUE(holds(replay("6\nwait\n<C-r>\nwait\n"), "nothing to redo"));

  EXPECT_TRUE(holds(replay("7\nwait\nw\nwait\n"), "written: "));
  const auto session = run_tapfit(fmt::format(
      "session '{}' -o '{}'", bundle.string(), (folder / "r.md").string()));
  ASSERT_EQ(session.exit_status, 0) << session.err;
  EXPECT_TRUE(holds(session.out, "as saved")) << session.out;
  const std::string report = read_file(bundle / "report.md");
  EXPECT_TRUE(holds(report, "+ added-mass at node 200")) << report;
  EXPECT_EQ(report, read_file(folder / "r.md"));
}

}  // namespace
}  // namespace tapfit::end_to_end
