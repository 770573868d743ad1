// The solved base that one run keeps for the next.
#include "tests/end_to_end/run_program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;

class BaseCacheTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    ::unsetenv("TAPFIT_NO_CACHE");
  }
  void TearDown() override {
    ::unsetenv("XDG_CACHE_HOME");
    ::setenv("TAPFIT_NO_CACHE", "1", 1);
  }

  [[nodiscard]] static std::string compared() {
    const ProgramResult result = run_tapfit(
        "compare '" TAPFIT_SOURCE_DIR "/recordings/solar-panel-frame' --json");
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return result.out;
  }
  [[nodiscard]] std::size_t files() const {
    if (!fs::exists(folder_ / "tapfit")) return 0;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_ / "tapfit"), {}));
  }

  const fs::path folder_ = fresh_folder() / "cache";
};

// JSON shows numbers to the last digit, so that equal texts are equal bits.
TEST_F(BaseCacheTest, ResultsAreTheSameToTheBitWithAndWithout) {
  ::setenv("TAPFIT_NO_CACHE", "1", 1);
  const std::string without = compared();
  EXPECT_EQ(files(), 0U);
  ::unsetenv("TAPFIT_NO_CACHE");
  EXPECT_EQ(compared(), without);
  EXPECT_EQ(files(), 2U);  // the mesh and the split mesh
  EXPECT_EQ(compared(), without);
  for (const auto& entry : fs::directory_iterator(folder_ / "tapfit")) {
    std::ofstream(entry.path()) << "not a base";
  }
  EXPECT_EQ(compared(), without);
}

}  // namespace
}  // namespace tapfit::end_to_end
