// Checks the architecture: rooms are those of the map in CONTRIBUTING.md and
// include what it allows, no pairs of files include each other in a circle, no
// room grows too large, and each C library is included by one pair of files.
#include "tests/project/include_graph.hpp"
#include "tests/project/room_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tapfit::project {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> folders{
    "acquisition", "signal", "modal", "updating", "tui"};
constexpr std::size_t most_pairs = 25;

/// Folders with sources that the map does not know, rooms that are too large.
std::vector<std::string> faults_of_rooms(
    const std::vector<Room>& map, const std::vector<std::string>& files) {
  std::map<std::string, std::set<std::string>> pairs;
  for (const std::string& file : files) {
    pairs[folder_of(file)].insert(pair_of(file));
  }
  std::vector<std::string> faults;
  for (const auto& [folder, held] : pairs) {
    if (std::ranges::find(map, folder, &Room::folder) == map.end()) {
      faults.push_back(fmt::format("{} is no room of the map", folder));
    }
    if (held.size() > most_pairs) {
      faults.push_back(fmt::format("{} holds {} pairs; {} are the most",
                                   folder,
                                   held.size(),
                                   most_pairs));
    }
  }
  return faults;
}

/// Every breach of the rules, one sentence each.
std::vector<std::string> breaches(const fs::path& root) {
  const std::vector<Room> map = read_room_map(root / "CONTRIBUTING.md");
  const std::vector<std::string> files = sources_in(root, folders);
  const std::vector<Include> includes = includes_of(root, files);
  std::vector<std::string> faults = faults_of_map(map, root);
  const auto add = [&faults](const std::vector<std::string>& more) {
    faults.insert(faults.end(), more.begin(), more.end());
  };
  add(faults_of_rooms(map, files));
  add(broken_walls(map, includes, root));
  for (const std::vector<std::string>& group : cycles(includes)) {
    faults.push_back(
        fmt::format("include each other: {}", fmt::join(group, ", ")));
  }
  for (const auto& [library, users] : shared_libraries(includes)) {
    faults.push_back(
        fmt::format("{} is included by {}", library, fmt::join(users, ", ")));
  }
  return faults;
}

/// A little source tree, healthy until a test poisons it.
class FlowRuleSample : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) /
            testing::UnitTest::GetInstance()->current_test_info()->name();
    write("CONTRIBUTING.md",
          "| room | holds | may include |\n|---|---|---|\n"
          "| `signal/spectra/` | FFT | nothing |\n"
          "| `signal/wing/` | a side wing | spectra; aside |\n"
          "| `modal/poles/` | poles | signal |\n"
          "| `modal/select/` | modes | signal, poles |\n");
    write("signal/spectra/fft.hpp", "#include <complex>\n");
    write("signal/spectra/fft.cpp",
          "#include \"signal/spectra/fft.hpp\"\n#include <fftw3.h>\n");
    write("signal/wing/virtual.hpp", "#include \"signal/spectra/fft.hpp\"\n");
    write("modal/poles/pole.hpp", "#include \"signal/spectra/fft.hpp\"\n");
    write("modal/select/mode.cpp", "#include \"modal/poles/pole.hpp\"\n");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }
  void expect(const std::string& breach) {
    EXPECT_EQ(breaches(root_), std::vector<std::string>{breach});
  }

  fs::path root_;
};

TEST(FlowRule, SourcesKeepToTheMap) {
  ASSERT_GT(
      read_room_map(fs::path(TAPFIT_SOURCE_DIR) / "CONTRIBUTING.md").size(),
      folders.size());
  for (const std::string& fault : breaches(TAPFIT_SOURCE_DIR)) {
    ADD_FAILURE() << fault;
  }
}

TEST_F(FlowRuleSample, HealthyTreeHasNoBreach) {
  EXPECT_EQ(breaches(root_), std::vector<std::string>{});
}

TEST_F(FlowRuleSample, IncludeToTheRightIsNamed) {
  write("signal/spectra/window.cpp",
        "\n  # include \"modal/poles/pole.hpp\" // why\n");
  expect(
      "signal/spectra/window.cpp:2: signal/spectra may not include "
      "modal/poles");
}

TEST_F(FlowRuleSample, IncludeOfALaterRoomIsNamed) {
  write("modal/select/mode.hpp", "#pragma once\n");
  write("modal/poles/plscf.cpp", "#include \"modal/select/mode.hpp\"\n");
  expect("modal/poles/plscf.cpp:1: modal/poles may not include modal/select");
}

TEST_F(FlowRuleSample, ASideWingHasToBeNamed) {
  write("modal/poles/plscf.cpp", "#include \"signal/wing/virtual.hpp\"\n");
  expect("modal/poles/plscf.cpp:1: modal/poles may not include signal/wing");
}

TEST_F(FlowRuleSample, ARoomThatIsNotThereIsNamed) {
  fs::remove_all(root_ / "modal/select");
  expect("the map's room modal/select holds no sources");
}

TEST_F(FlowRuleSample, AFolderThatTheMapDoesNotKnowIsNamed) {
  write("modal/fit/fit.cpp", "#include <vector>\n");
  expect("modal/fit is no room of the map");
}

TEST_F(FlowRuleSample, ANameThatIsNoRoomAboveIsNamed) {
  write("CONTRIBUTING.md",
        "| `signal/spectra/` | FFT | wing |\n"
        "| `signal/wing/` | a side wing | spectra; aside |\n"
        "| `modal/poles/` | poles | signal |\n"
        "| `modal/select/` | modes | signal, poles |\n");
  expect("the map lets signal/spectra include wing, which is no room above it");
}

TEST_F(FlowRuleSample, PairsThatIncludeEachOtherAreNamed) {
  write("modal/poles/pole.cpp", "#include \"modal/poles/order.hpp\"\n");
  write("modal/poles/order.hpp", "#include \"modal/poles/track.hpp\"\n");
  write("modal/poles/track.hpp", "#include \"modal/poles/pole.hpp\"\n");
  expect(
      "include each other: modal/poles/order, modal/poles/pole, "
      "modal/poles/track");
}

TEST_F(FlowRuleSample, ARoomThatIsTooLargeIsNamed) {
  for (std::size_t k = 0; k < most_pairs; ++k) {
    write(fmt::format("modal/poles/more_{}.hpp", k), "#pragma once\n");
  }
  expect("modal/poles holds 26 pairs; 25 are the most");
}

TEST_F(FlowRuleSample, HeaderThatIsNotThereIsNamed) {
  write("signal/spectra/window.cpp", "#include \"fft.hpp\"\n");
  expect(
      "signal/spectra/window.cpp:1: \"fft.hpp\" is not there; write it from "
      "the repository's root");
}

TEST_F(FlowRuleSample, SecondUserOfACLibraryIsNamed) {
  write("signal/spectra/window.cpp", "#include <fftw3.h>\n");
  expect("fftw3 is included by signal/spectra/fft, signal/spectra/window");
}

}  // namespace
}  // namespace tapfit::project
