// Whatever a test in the folder is called: what it reads is an input.
#include "updating/export/output_rule_of_folder.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

class RuleOfFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name :
         {"run-01.flac", "run-02.flac", "model.bdf", "grids.inc", "m.unv"}) {
      folder_.write(name, "");
    }
    folder_.write("model.bdf", "INCLUDE 'gone.inc'\nINCLUDE 'grids.inc'\n");
    folder_.write("notes.json", R"({"file": "notes.txt"})");
    folder_.write("notes.txt", "");
  }
  [[nodiscard]] bool is_input(const std::string& name,
                              const std::vector<fs::path>& made = {}) const {
    return output_rule_of_folder(folder_.path(), true, made)
        .is_input(folder_.path() / name);
  }

  ::tapfit::testing::TemporaryFolder folder_;
  const char* test_ = R"({"tapfit": 1, "model": "model.bdf",
    "runs": [{"file": "run-01.flac"}], "geometry": {"file": "./m.unv"}})";
};

TEST_F(RuleOfFolder, NamesAllThatATestOfAnyNameReads) {
  folder_.write("campaign.txt", test_);
  for (const char* name : {"campaign.txt",
                           "model.bdf",
                           "grids.inc",
                           "gone.inc",
                           "run-01.flac",
                           "m.unv"}) {
    EXPECT_TRUE(is_input(name)) << name;
  }
  for (const char* name : {"run-02.flac", "notes.txt", "notes.json"}) {
    EXPECT_FALSE(is_input(name)) << name;
  }
}

// Numbers, and what else is no name, hide none behind them.
TEST_F(RuleOfFolder, NamesFilesBehindNumbers) {
  folder_.write("campaign.json",
                R"({"tapfit": 1, "band_hz": [1, 2.5],
    "runs": [{"hits": [0.5, true, null], "file": "run-02.flac"}]})");
  EXPECT_TRUE(is_input("run-02.flac"));
  EXPECT_FALSE(is_input("run-01.flac"));
}

TEST_F(RuleOfFolder, NamesATestThatCannotBeRead) {
  folder_.write("test.json", "{\"tapfit\": 1,");
  EXPECT_TRUE(is_input("test.json"));
  EXPECT_FALSE(is_input("run-01.flac"));
}

TEST_F(RuleOfFolder, LetsWhatWasMadeUnlessAnotherTestReadsIt) {
  const std::vector<fs::path> made{folder_.write("test.json", test_),
                                   folder_.path() / "model.bdf"};
  EXPECT_FALSE(is_input("test.json", made));
  EXPECT_FALSE(is_input("model.bdf", made));
  EXPECT_TRUE(is_input("run-01.flac", made)) << "not as it was made";
  folder_.write("campaign.json", test_);
  EXPECT_FALSE(is_input("test.json", made));
  EXPECT_TRUE(is_input("model.bdf", made));
}

TEST_F(RuleOfFolder, NeedsNoFolder) {
  EXPECT_TRUE(
      output_rule_of_folder(folder_.path() / "none", false).inputs.empty());
}

}  // namespace
}  // namespace tapfit::updating
