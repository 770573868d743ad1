// All that a test reads is an input, also what its deck includes.
#include "updating/export/output_rule_of.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

TEST(OutputRuleOf, NamesAllThatATestReads) {
  const testing::TemporaryFolder folder;
  acquisition::TestBundle bundle;
  bundle.folder = folder.path();
  bundle.file = folder.write("test.json", "{}");
  bundle.frfs = folder.write("measured.uff", "");
  bundle.geometry.emplace().file = folder.write("mesh.csv", "");
  bundle.deck = folder.write("model.bdf", "INCLUDE 'grids.bdf'\nENDDATA\n");
  folder.write("grids.bdf", "INCLUDE 'more.bdf'\n");
  folder.write("more.bdf", "INCLUDE 'gone.bdf'\n");
  bundle.matrices = acquisition::MatrixModel{folder.write("K.mtx", ""),
                                             folder.write("M.mtx", ""),
                                             folder.write("dofs.csv", "")};
  bundle.runs.resize(1);
  bundle.runs[0].file = folder.write("run-01.wav", "");
  const acquisition::OutputRule rule = output_rule_of(bundle, true);
  for (const char* name : {"test.json",
                           "session.json",
                           "measured.uff",
                           "mesh.csv",
                           "model.bdf",
                           "grids.bdf",
                           "more.bdf",
                           "gone.bdf",
                           "K.mtx",
                           "M.mtx",
                           "dofs.csv",
                           "run-01.wav"}) {
    EXPECT_TRUE(rule.is_input(folder.path() / name)) << name;
    EXPECT_THROW(rule.check(folder.path() / name), InputError) << name;
  }
  EXPECT_FALSE(rule.is_input(folder.path() / "report.md"));
}

// One INCLUDE that is not there, or that is no deck, hides no other.
TEST(OutputRuleOf, NamesTheIncludesOfADeckThatCannotBeRead) {
  const testing::TemporaryFolder folder;
  acquisition::TestBundle bundle;
  bundle.folder = folder.path();
  bundle.file = folder.write("test.json", "{}");
  bundle.deck = folder.write("model.bdf",
                             "INCLUDE 'gone.inc'\nINCLUDE 'text.inc'\n"
                             "INCLUDE 'model.bdf'\nINCLUDE 'head.inc'\n");
  folder.write("text.inc", "This is no deck, but a page of prose.\n");
  folder.write("head.inc", "INCLUDE './tail.inc'\nINCLUDE 'open.inc\n");
  folder.write("tail.inc", "INCLUDE 'head.inc'\n");
  const acquisition::OutputRule rule = output_rule_of(bundle, true);
  for (const char* name : {"gone.inc",
                           "text.inc",
                           "model.bdf",
                           "head.inc",
                           "tail.inc",
                           "open.inc"}) {
    EXPECT_TRUE(rule.is_input(folder.path() / name)) << name;
  }
}

// Several tests may share a folder, and an output may go to another test's.
TEST(OutputRuleOf, NamesWhatTestsBesideItRead) {
  const testing::TemporaryFolder folder;
  const fs::path other = folder.path() / "other";
  fs::create_directory(other);
  acquisition::TestBundle bundle;
  bundle.folder = folder.path();
  bundle.file = folder.write("second.json", R"({"tapfit": 1})");
  folder.write("test.json", R"({"tapfit": 1, "frfs": "measured.uff"})");
  folder.write("measured.uff", "");
  folder.write("other/test.json", R"({"tapfit": 1, "frfs": "other.uff"})");
  folder.write("other/other.uff", "");
  const acquisition::OutputRule rule =
      output_rule_of(bundle, true, {other / "out.uff"});
  EXPECT_TRUE(rule.is_input(folder.path() / "test.json"));
  EXPECT_TRUE(rule.is_input(folder.path() / "measured.uff"));
  EXPECT_TRUE(rule.is_input(other / "test.json"));
  EXPECT_TRUE(rule.is_input(other / "other.uff"));
  EXPECT_FALSE(rule.is_input(other / "out.uff"));
}

TEST(OutputRuleOf, AUniversalFileIsATestByItself) {
  const testing::TemporaryFolder folder;
  acquisition::TestBundle bundle;
  bundle.folder = folder.path();
  bundle.file = folder.write("plate.uff", "");
  bundle.uff = bundle.file;
  const acquisition::OutputRule rule = output_rule_of(bundle, false);
  EXPECT_TRUE(rule.is_input(folder.path() / "plate.uff"));
  EXPECT_TRUE(rule.is_input(folder.path() / "plate.uff.session.json"));
}

}  // namespace
}  // namespace tapfit::updating
