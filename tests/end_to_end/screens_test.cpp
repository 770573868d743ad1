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

}  // namespace
}  // namespace tapfit::end_to_end
