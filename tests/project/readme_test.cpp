// What README.md and pages of docs/ quote must exist: every `tapfit` command
// line parses, every file that is linked is there.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = TAPFIT_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> matches(const std::string& text,
                                 const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end;
       match != end;
       ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

/// First words after "tapfit" in code, for example "diagnose".
std::set<std::string> quoted_commands(const std::string& page) {
  std::set<std::string> commands;
  for (const auto& word : matches(page, R"((?:`|    |\| )tapfit ([a-z]+)\b)")) {
    commands.insert(word);
  }
  return commands;
}

class Page : public testing::TestWithParam<const char*> {};

TEST_P(Page, QuotedCommandsExist) {
  const auto commands = quoted_commands(read(root / GetParam()));
  EXPECT_GE(commands.size(), 3U) << "the page quotes hardly any command";
  for (const std::string& command : commands) {
    const std::string line =
        "'" TAPFIT_PROGRAM "' " + command + " --help >/dev/null 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0) << "tapfit " << command;
  }
}

TEST_P(Page, LinkedFilesExist) {
  const fs::path page = root / GetParam();
  for (const auto& link :
       matches(read(page), R"(\]\(([^)#:]+)(?:#[^)]*)?\))")) {
    EXPECT_TRUE(fs::exists(page.parent_path() / link)) << link;
  }
}

INSTANTIATE_TEST_SUITE_P(Pages,
                         Page,
                         testing::Values("README.md",
                                         "docs/commands.md",
                                         "docs/real-test.md",
                                         "docs/tutorial.md"),
                         [](const auto& page) {
                           std::string name = fs::path(page.param).stem();
                           std::erase(name, '-');
                           return name;
                         });

TEST(QuotedCommands, AreFoundInCodeOnly) {
  EXPECT_EQ(quoted_commands("tapfit is\n    tapfit run x\n`tapfit hits B`"),
            (std::set<std::string>{"run", "hits"}));
}

}  // namespace
