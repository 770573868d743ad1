// The commands that read their own command line: what is wrong with it is told
// apart from what is wrong with the input.
#include "acquisition/foundation/input_error.hpp"
#include "tui/practice/score_command.hpp"
#include "tui/practice/simulate_command.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

struct Ran {
  int status = 0;
  std::string err;
};

Ran ran(std::vector<const char*> arguments,
        int (*command)(int, const char* const*, const Progress&)) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  Ran result;
  result.status =
      command(static_cast<int>(arguments.size()), arguments.data(), {});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  result.err = testing::internal::GetCapturedStderr();
  return result;
}

TEST(SimulateCommand, WordsThatAreNoEffectAreStatusTwo) {
  const fs::path folder = fs::path(testing::TempDir()) / "tapfit-no-effect";
  fs::remove_all(folder);  // of a run that failed
  for (const char* effect : {"magic=1",
                             "added-mass@201x=1",
                             "channel-swap@acc1:acc1",
                             "soft-support@both=10"}) {
    const Ran result =
        ran({"simulate", folder.c_str(), "--effect", effect}, simulate_command);
    EXPECT_EQ(result.status, 2) << effect;
    EXPECT_NE(result.err.find(effect), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("Write one of"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder)) << effect;
  }
}

TEST(SimulateCommand, ABandTheWrongWayRoundIsStatusTwo) {
  const fs::path folder = fs::path(testing::TempDir()) / "tapfit-no-band";
  const Ran result =
      ran({"simulate", folder.c_str(), "--band", "60", "5"}, simulate_command);
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--band"), std::string::npos) << result.err;
}

TEST(ScoreCommand, AShardThatIsNoneIsStatusTwo) {
  for (const char* shard : {"3/2", "0/2", "1/0", "1", "1/2x", "-1/2", "a/b"}) {
    const Ran result =
        ran({"score", "--cases", "1", "--shard", shard}, score_command);
    EXPECT_EQ(result.status, 2) << shard;
    EXPECT_NE(result.err.find(shard), std::string::npos) << result.err;
  }
}

TEST(ScoreCommand, PartsThatAreNoneAreRefusedByName) {
  const fs::path part = fs::path(testing::TempDir()) / "tapfit-part.json";
  for (const char* text : {"",
                           "[]",
                           "{}",
                           R"({"cases": 5})",
                           R"({"cases": [1]})",
                           R"({"cases": [{}]})",
                           R"({"cases": [{"hidden": 1, "found": "none"}]})"}) {
    std::ofstream(part) << text;
    try {
      const std::array words{"score", "--merge", part.c_str()};
      (void)score_command(3, words.data(), {});
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), part.string()) << text;
    }
  }
}

}  // namespace
}  // namespace tapfit::tui
