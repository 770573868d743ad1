// What `cmake --install` puts beside the program: every relative link of its
// pages leads to a file that is installed, too.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

class InstalledPages : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    fs::create_directories(root_);
    const std::string build = fs::path(TAPFIT_PROGRAM).parent_path();
    const std::string command = "cmake --install '" + build +
                                "' --component tapfit --prefix '" +
                                root_.string() + "' >/dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  void TearDown() override { fs::remove_all(root_); }

  const fs::path root_ = fs::path(testing::TempDir()) /
                         ("tapfit-installed-" + std::to_string(::getpid()));
};

// Counts the links of a page; those that lead nowhere are failures.
int check_links(const fs::path& page) {
  std::ifstream file(page);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  static const std::regex link(R"(\]\(([^)#:]+)(?:#[^)]*)?\))");
  int count = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end;
       ++at, ++count) {
    const std::string to = (*at)[1];
    EXPECT_TRUE(fs::exists(page.parent_path() / to)) << page << ": " << to;
  }
  return count;
}

TEST_F(InstalledPages, LinkToWhatIsInstalled) {
  int pages = 0;
  int links = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root_)) {
    if (entry.path().extension() != ".md") continue;
    ++pages;
    links += check_links(entry.path());
  }
  EXPECT_GT(pages, 50);
  EXPECT_GT(links, 50);
}

}  // namespace
