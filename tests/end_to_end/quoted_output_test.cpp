// Pages of docs/ that go through a test command by command: every command works
// as it is quoted and prints what is quoted below it.
#include "tests/end_to_end/quoted_output.hpp"

#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;

const fs::path root = TAPFIT_SOURCE_DIR;

// As in the folder that the page is read in, and files go to the test's own.
std::string placed(std::string arguments, const fs::path& folder) {
  const auto replace = [&arguments](const std::string& what,
                                    const std::string& by) {
    for (std::size_t at = arguments.find(what); at != std::string::npos;
         at = arguments.find(what, at + by.size())) {
      arguments.replace(at, what.size(), by);
    }
  };
  replace("/tmp/", (folder / "").string());
  replace("recordings/", (root / "recordings" / "").string());
  return arguments;
}

class QuotedOutput : public ::testing::TestWithParam<const char*> {};

TEST_P(QuotedOutput, IsWhatTheProgramPrints) {
  const auto commands = quoted_commands(read_file(root / GetParam()));
  ASSERT_GE(commands.size(), 4U);
  for (const auto& [arguments, printed] : commands) {
    const auto result = run_tapfit(placed(arguments, fresh_folder()));
    ASSERT_EQ(result.exit_status, 0) << arguments << "\n" << result.err;
    EXPECT_EQ(not_printed(printed, result.out), "")
        << "tapfit " << arguments << "\n"
        << result.out;
  }
}

INSTANTIATE_TEST_SUITE_P(Pages,
                         QuotedOutput,
                         ::testing::Values("docs/tutorial.md",
                                           "docs/real-test.md"),
                         [](const auto& page) {
                           std::string name = fs::path(page.param).stem();
                           std::erase(name, '-');
                           return name;
                         });

TEST(QuotedCommands, HaveWhatFollowsThemAndNoProse) {
  const auto commands = quoted_commands(
      "Text\n\n    tapfit model x\n\n    Model:\n      1\n\nText\n\n    2\n"
      "    tapfit modes y\nText\n    3\n");
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_EQ(commands[0].arguments, "model x");
  EXPECT_EQ(commands[0].printed.size(), 2U);
  EXPECT_TRUE(commands[1].printed.empty());
}

TEST(QuotedCommands, AreComparedWordByWordAndToTheDigitsQuoted) {
  const std::string output = "Error 1.234 %\n\n  a\n  b 20.05 (3 of 4)\n";
  EXPECT_EQ(not_printed({"Error 1.23 %", "a"}, output), "");
  EXPECT_EQ(not_printed({"...", "b 20.1 (3 of 4)"}, output), "");
  EXPECT_EQ(not_printed({"Error 1.27 %"}, output), "Error 1.27 %");
  EXPECT_EQ(not_printed({"a"}, output), "a") << "it is not the first line";
  EXPECT_EQ(not_printed({"Error 1.23 %", "b 20 (3 of 4)"}, output),
            "b 20 (3 of 4)");
  EXPECT_EQ(not_printed({"...", "a", "..."}, output), "");
  EXPECT_EQ(not_printed({"...", "c"}, output), "c");
}

}  // namespace
}  // namespace tapfit::end_to_end
