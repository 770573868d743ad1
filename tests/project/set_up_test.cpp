// What run.sh and test.sh say before the first build: how long it takes, each
// for what it builds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace tapfit::project {
namespace {

namespace fs = std::filesystem;

class SetUp : public ::testing::Test {
 protected:
  // A tree in which nothing is installed or built.
  SetUp() {
    fs::remove_all(root_);
    fs::create_directories(root_ / "cmake");
    fs::create_directories(root_ / "bin");
    fs::copy_file(TAPFIT_SOURCE_DIR "/cmake/set_up.sh",
                  root_ / "cmake" / "set_up.sh");
    for (const char* name : {"cmake/install_packages.sh", "bin/cmake"}) {
      std::ofstream(root_ / name) << "#!/bin/sh\n";
      fs::permissions(root_ / name, fs::perms::owner_all);
    }
  }
  ~SetUp() override { fs::remove_all(root_); }

  [[nodiscard]] std::string said(const std::string& target) const {
    const std::string root = root_.string();
    const std::string command = "PATH='" + root + "/bin':\"$PATH\" sh '" +
                                root + "/cmake/set_up.sh' " + target + " 2>'" +
                                root + "/said'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream file(root_ / "said");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path root_ = fs::path(::testing::TempDir()) / "tapfit-set-up";
};

// Measured on two quiet cores without a compiler cache: 9.5 minutes for the
// program; with all tests it is twice the work.
TEST_F(SetUp, SaysHowLongTheFirstBuildTakes) {
  EXPECT_NE(said("tapfit").find("about 10 minutes on two cores"),
            std::string::npos);
  EXPECT_NE(said("").find("about 20 minutes on two cores"), std::string::npos);
  fs::create_directories(root_ / "build" / "release");
  std::ofstream(root_ / "build" / "release" / "tapfit");
  EXPECT_EQ(said("tapfit"), "");
  // The tests are still to be built.
  EXPECT_NE(said("").find("about 10 minutes on two cores"), std::string::npos);
  fs::create_directories(root_ / "build" / "release" / "tests");
  std::ofstream(root_ / "build" / "release" / "tests" / "end_to_end_tests");
  EXPECT_EQ(said(""), "");
}

}  // namespace
}  // namespace tapfit::project
