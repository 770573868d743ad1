// What tests of written files share: a test that the program writes beside, a
// shell that stands for a full disk, and what is left of files half written.
#pragma once

#include "tests/end_to_end/run_program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::end_to_end {

/// The folder of the demonstration bundles.
[[nodiscard]] std::filesystem::path recordings();

/// The command through the shell, "%tapfit" in it replaced by the program.
/// @return its exit status, or the signal that ended it, negative
int shell_status(std::string command);

/// Names of files in the folder that were not written to their end.
[[nodiscard]] std::vector<std::string> parts_in(
    const std::filesystem::path& folder);

/// A small test with recordings; made once.
[[nodiscard]] const std::filesystem::path& recorded();

/// A copy of a bundle of FRFs.
class OutputsOfATest : public testing::Test {
 protected:
  void SetUp() override {
    bundle_ = fresh_folder() / "truss";
    std::filesystem::copy(recordings() / "paper-truss", bundle_);
  }
  [[nodiscard]] ProgramResult run(const std::string& command,
                                  const std::string& options) const {
    return run_tapfit(command + " '" + bundle_.string() + "' " + options);
  }
  [[nodiscard]] std::string in_bundle(const std::string& name) const {
    return "'" + (bundle_ / name).string() + "'";
  }
  [[nodiscard]] std::string keys(const std::string& script) const {
    write_file(bundle_ / "keys.txt", script);
    const auto seen =
        run_tapfit("'" + bundle_.string() + "' --width 200 --keys " +
                   in_bundle("keys.txt"));
    EXPECT_EQ(seen.exit_status, 0) << seen.err;
    return seen.out;
  }

  std::filesystem::path bundle_;
};

}  // namespace tapfit::end_to_end
