#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

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

fs::path scratch_folder(const std::string& name) {
  struct Made {
    std::vector<fs::path> folders;
    ~Made() {
      std::error_code ignored;
      for (const fs::path& folder : folders) fs::remove_all(folder, ignored);
    }
  };
  static Made made;
  made.folders.push_back(fs::path(testing::TempDir()) /
                         fmt::format("tapfit-{}-{}", ::getpid(), name));
  fs::remove_all(made.folders.back());
  fs::create_directories(made.folders.back());
  return made.folders.back();
}

fs::path fresh_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  // Null while a suite is set up.
  const std::string name =
      test == nullptr
          ? "suite"
          : fmt::format("{}-{}", test->test_suite_name(), test->name());
  static std::string made_for;
  static fs::path folder;
  if (made_for != name) folder = scratch_folder(name);
  made_for = name;
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
