// Checks the architecture: data flows acquisition -> signal -> modal ->
// updating -> tui, so a folder includes only itself and folders to its left,
// and each C library is included by one pair of files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 5> folders{
    "acquisition", "signal", "modal", "updating", "tui"};

/// Rank in the flow; folders.size() for a name that is no folder of ours.
std::size_t rank(const std::string& folder) {
  return static_cast<std::size_t>(
      std::find(folders.begin(), folders.end(), folder) - folders.begin());
}

/// The C library a <...> header belongs to; empty for any other header.
std::string c_library(const std::string& header) {
  static const std::regex pattern(
      R"(^(?:suitesparse/|ncursesw/|ncurses/)?)"
      R"((fftw3|sndfile|matio|zlib|ncurses|curses|panel|cholmod)\.(?:h|hh)$)");
  std::smatch match;
  if (!std::regex_match(header, match, pattern)) return {};
  const std::string name = match[1];
  return name == "curses" || name == "panel" ? "ncurses" : name;
}

class FlowChecker {
 public:
  explicit FlowChecker(fs::path root) : root_(std::move(root)) {}

  /// Every breach of the rule, one sentence each.
  std::vector<std::string> breaches() {
    for (const char* folder : folders) check_folder(folder);
    for (const auto& [library, users] : users_) {
      if (users.size() > 1) {
        faults_.push_back(fmt::format("{} is included by {} and {}",
                                      library,
                                      *users.begin(),
                                      *std::next(users.begin())));
      }
    }
    return faults_;
  }

 private:
  void check_folder(const std::string& folder) {
    if (!fs::exists(root_ / folder)) return;
    for (const auto& entry : fs::recursive_directory_iterator(root_ / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".hpp" || extension == ".cpp" || extension == ".h") {
        check_file(folder, entry.path());
      }
    }
  }

  void check_file(const std::string& folder, const fs::path& path) {
    static const std::regex include(
        R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*$)");
    std::ifstream file(path);
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      const std::string place =
          fmt::format("{}:{}", fs::relative(path, root_).string(), number);
      if (match[1] == "\"") {
        check_own_include(folder, match[2], place);
      } else if (const auto library = c_library(match[2]); !library.empty()) {
        users_[library].insert(
            fs::relative(path, root_).replace_extension().string());
      }
    }
  }

  void check_own_include(const std::string& folder,
                         const std::string& header,
                         const std::string& place) {
    const std::string target = header.substr(0, header.find('/'));
    if (rank(target) == folders.size()) {
      faults_.push_back(
          fmt::format("{}: \"{}\" is not written from the repository's root",
                      place,
                      header));
    } else if (rank(target) > rank(folder)) {
      faults_.push_back(
          fmt::format("{}: {} may not include {}", place, folder, target));
    }
    if (!fs::exists(root_ / header)) {
      faults_.push_back(fmt::format("{}: {} is not there", place, header));
    }
  }

  fs::path root_;
  std::vector<std::string> faults_;
  std::map<std::string, std::set<std::string>> users_;
};

/// A little source tree, healthy until a test poisons it.
class FlowRuleSample : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) /
            testing::UnitTest::GetInstance()->current_test_info()->name();
    write("signal/fft.hpp", "#include <complex>\n");
    write("signal/fft.cpp", "#include \"signal/fft.hpp\"\n#include <fftw3.h>");
    write("modal/pole.cpp", "#include \"signal/fft.hpp\"\n");
    write("tui/view.cpp", "#include \"modal/pole.hpp\"\n");
    write("modal/pole.hpp", "#pragma once\n");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }
  std::vector<std::string> breaches() { return FlowChecker(root_).breaches(); }

  fs::path root_;
};

TEST(FlowRule, SourcesIncludeOnlyToTheLeft) {
  for (const std::string& fault : FlowChecker(TAPFIT_SOURCE_DIR).breaches()) {
    ADD_FAILURE() << fault;
  }
}

TEST_F(FlowRuleSample, HealthyTreeHasNoBreach) {
  EXPECT_EQ(breaches(), std::vector<std::string>{});
}

TEST_F(FlowRuleSample, IncludeToTheRightIsNamed) {
  write("signal/window.cpp", "\n  # include \"modal/pole.hpp\" // why\n");
  EXPECT_EQ(breaches(),
            std::vector<std::string>{
                "signal/window.cpp:2: signal may not include modal"});
}

TEST_F(FlowRuleSample, IncludeFromTheFolderItselfIsNamed) {
  write("signal/window.cpp", "#include \"fft.hpp\"\n");
  ASSERT_FALSE(breaches().empty());
  EXPECT_EQ(breaches().front(),
            "signal/window.cpp:1: \"fft.hpp\" is not written from the "
            "repository's root");
}

TEST_F(FlowRuleSample, MissingHeaderIsNamed) {
  write("tui/view.cpp", "#include \"modal/gone.hpp\"\n");
  EXPECT_EQ(
      breaches(),
      std::vector<std::string>{"tui/view.cpp:1: modal/gone.hpp is not there"});
}

TEST_F(FlowRuleSample, SecondUserOfACLibraryIsNamed) {
  write("signal/window.cpp", "#include <fftw3.h>\n");
  EXPECT_EQ(breaches(),
            std::vector<std::string>{"fftw3 is included by signal/fft and "
                                     "signal/window"});
}

}  // namespace
