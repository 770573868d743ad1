// The solved base that one run keeps for the next.
#include "tests/end_to_end/run_program.hpp"
#include "tests/end_to_end/small_bundle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;

class BaseCacheTest : public WithCache {
 protected:
  [[nodiscard]] static std::string compared() {
    const ProgramResult result = run_tapfit(
        "compare '" TAPFIT_SOURCE_DIR "/recordings/solar-panel-frame' --json");
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return result.out;
  }
  [[nodiscard]] std::size_t files() const {
    if (!fs::exists(cache() / "tapfit")) return 0;
    const fs::directory_iterator all(cache() / "tapfit");
    return static_cast<std::size_t>(std::count_if(
        begin(all), end(all), [](const fs::directory_entry& entry) {
          return entry.path().extension() == ".matrices";
        }));
  }
};

// What one run found is there for the next, as long as nothing changed.
TEST_F(BaseCacheTest, ADiagnosisIsKeptUntilSomethingChanges) {
  const fs::path bundle = fresh_folder() / "bundle";
  ASSERT_EQ(run_tapfit("simulate '" + bundle.string() +
                       "' --structure portal --effect none --runs 3 --hits 2")
                .exit_status,
            0);
  const auto diagnosed = [&bundle] {
    const ProgramResult result =
        run_tapfit("diagnose '" + bundle.string() + "' --json");
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return result.out;
  };
  const std::string first = diagnosed();
  const std::size_t kept = files();
  EXPECT_EQ(kept, 3U);  // two bases and the diagnosis
  EXPECT_EQ(diagnosed(), first);
  EXPECT_EQ(files(), kept);
  // Any change of test.json counts.
  std::ifstream in(bundle / "test.json");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text.insert(text.find('{') + 1, "\n");
  std::ofstream(bundle / "test.json") << text;
  static_cast<void>(diagnosed());
  EXPECT_EQ(files(), kept + 1);
}

// JSON shows numbers to the last digit, so that equal texts are equal bits.
TEST_F(BaseCacheTest, ResultsAreTheSameToTheBitWithAndWithout) {
  ::setenv("TAPFIT_NO_CACHE", "1", 1);
  const std::string without = compared();
  EXPECT_EQ(files(), 0U);
  ::unsetenv("TAPFIT_NO_CACHE");
  EXPECT_EQ(compared(), without);
  EXPECT_EQ(files(), 2U);  // the mesh and the split mesh
  EXPECT_TRUE(fs::exists(cache() / "tapfit" / "fftw-wisdom"));
  EXPECT_EQ(compared(), without);
  for (const auto& entry : fs::directory_iterator(cache() / "tapfit")) {
    std::ofstream(entry.path()) << "neither a base nor wisdom";
  }
  EXPECT_EQ(compared(), without);
}

}  // namespace
}  // namespace tapfit::end_to_end
