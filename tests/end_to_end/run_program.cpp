#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sys/wait.h>

namespace tapfit::end_to_end {

namespace fs = std::filesystem;

ProgramResult run_tapfit(const std::string& arguments) {
  const fs::path folder = fresh_folder() / "output";
  fs::create_directories(folder);
  const std::string command = fmt::format("'{}' {} </dev/null >'{}' 2>'{}'",
                                          TAPFIT_PROGRAM,
                                          arguments,
                                          (folder / "out").string(),
                                          (folder / "err").string());
  const int status = std::system(command.c_str());
  return {.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .out = read_file(folder / "out"),
          .err = read_file(folder / "err")};
}

fs::path fresh_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  // Null while a suite is set up.
  const std::string name =
      test == nullptr
          ? "suite"
          : fmt::format("{}-{}", test->test_suite_name(), test->name());
  const fs::path folder = fs::path(testing::TempDir()) / ("tapfit-" + name);
  static std::string emptied;
  if (emptied != folder) {
    fs::remove_all(folder);
    emptied = folder;
  }
  fs::create_directories(folder);
  return folder;
}

void write_file(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path);
  file << text;
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace tapfit::end_to_end
