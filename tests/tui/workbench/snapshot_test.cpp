// Every screen as text, cell by cell, at three sizes, with and without
// Unicode: files in tests/tui/screens. After a wanted change,
//
//   TAPFIT_WRITE_SCREENS=1 build/release/tests/tui_tests
//     --gtest_filter='*Screens*'
//
// writes them anew, to be looked at before they are committed.
#include "tests/tui/support/fake_workbench.hpp"
#include "tui/app/program.hpp"
#include "tui/app/replay.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace tapfit::tui {
namespace {

struct Shot {
  std::string name;
  std::string keys;
};

const std::vector<Shot> shots{
    {"recording", "wait"},
    {"recording-runs", "wait\no\nwait"},
    {"recording-pulse", "wait\n<Enter>"},
    {"frf-phase", "2\nwait\nn"},
    {"frf-parts", "2\nwait\n <Tab><Tab>"},
    {"frf-nyquist", "2\nwait\nn<Tab><Tab><Tab>"},
    {"frf-checks", "2\nwait\nd"},
    {"modes", "3\nwait"},
    {"modes-mac", "3\nwait\nm\nwait"},
    {"compare", "4\nwait"},
    {"compare-structure", "4\nwait\n<Tab><Tab><Tab><Tab>"},
    {"diagnose", "5\nwait"},
    {"diagnose-effect", "5\nwait\ne\nwait"},
    {"diagnose-map", "5\nwait\nm\nwait"},
    {"update", "5\nwait\na\nwait"},
    {"update-effect", "5\nwait\na\nwait\n<Tab>\nwait"},
    {"update-convergence", "5\nwait\na\nwait\n<Tab><Tab>\nwait"},
    {"report", "7\nwait"},
    {"help", "5\nwait\n?"},
};

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Screens : public ::testing::TestWithParam<Canvas> {};

TEST_P(Screens, AreAsTheyWere) {
  const Canvas canvas = GetParam();
  const std::filesystem::path folder =
      std::filesystem::path(TAPFIT_SOURCE_DIR) / "tests/tui/screens" /
      fmt::format(
          "{}x{}{}", canvas.width, canvas.height, canvas.ascii ? "-ascii" : "");
  const bool write = std::getenv("TAPFIT_WRITE_SCREENS") != nullptr;
  if (write) std::filesystem::create_directories(folder);
  for (const Shot& shot : shots) {
    Program program(testing::fake_workbench(), canvas);
    const std::string text = replay(program, parse_key_script(shot.keys));
    const std::filesystem::path file = folder / (shot.name + ".txt");
    if (write) std::ofstream(file) << text;
    EXPECT_EQ(text, read(file)) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes,
                         Screens,
                         ::testing::Values(Canvas{80, 24, false},
                                           Canvas{120, 35, false},
                                           Canvas{200, 50, false},
                                           Canvas{80, 24, true}),
                         [](const auto& one) {
                           return fmt::format("w{}h{}{}",
                                              one.param.width,
                                              one.param.height,
                                              one.param.ascii ? "ascii" : "");
                         });

}  // namespace
}  // namespace tapfit::tui
