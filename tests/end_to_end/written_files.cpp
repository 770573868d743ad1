#include "tests/end_to_end/written_files.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <sys/wait.h>

namespace tapfit::end_to_end {

namespace fs = std::filesystem;

fs::path recordings() { return TAPFIT_SOURCE_DIR "/recordings"; }

int shell_status(std::string command) {
  const std::string name = "%tapfit";
  command.replace(command.find(name), name.size(), "'" TAPFIT_PROGRAM "'");
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::vector<std::string> parts_in(const fs::path& folder) {
  std::vector<std::string> parts;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".part")) parts.push_back(name);
  }
  return parts;
}

const fs::path& recorded() {
  static const fs::path bundle = [] {
    const fs::path folder = scratch_folder("recorded") / "test";
    const auto made = run_tapfit(
        fmt::format("simulate '{}' --structure ladder --seed 5 --runs 4 "
                    "--hits 2",
                    folder.string()));
    EXPECT_EQ(made.exit_status, 0) << made.err;
    return folder;
  }();
  return bundle;
}

}  // namespace tapfit::end_to_end
