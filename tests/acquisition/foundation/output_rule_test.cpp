#include "acquisition/foundation/output_rule.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

class OutputRuleTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string refusal(const fs::path& output, bool force) const {
    try {
      OutputRule{{input_, folder_.path() / "gone.wav"}, force}.check(output);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  static bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  testing::TemporaryFolder folder_;
  fs::path input_ = folder_.write("measured.uff", "measured");
};

TEST_F(OutputRuleTest, InputIsNeverWrittenByWhateverName) {
  const fs::path folder = folder_.path();
  fs::create_symlink("measured.uff", folder / "link.uff");
  fs::create_hard_link(input_, folder / "hard.uff");
  fs::create_directory(folder / "sub");
  for (const fs::path& name : {input_,
                               folder / "." / "measured.uff",
                               folder / "sub" / ".." / "measured.uff",
                               folder / "link.uff",
                               folder / "hard.uff",
                               folder / "gone.wav",
                               folder / "sub" / ".." / "gone.wav"}) {
    for (const bool force : {false, true}) {
      EXPECT_TRUE(holds(refusal(name, force), "is an input")) << name;
    }
  }
  EXPECT_TRUE(holds(refusal(input_, true), "such as measured-2.uff"));
}

TEST_F(OutputRuleTest, AnotherFileIsReplacedWhereThatIsAskedFor) {
  const fs::path file = folder_.write("report.md", "older");
  folder_.write("report-2.md", "older");
  EXPECT_TRUE(holds(refusal(file, false), "report-3.md"));
  EXPECT_TRUE(holds(refusal(file, false), "--force"));
  EXPECT_EQ(refusal(file, true), "");
  EXPECT_EQ(refusal(folder_.path() / "new.md", false), "");
  EXPECT_EQ(refusal("/dev/null", false), "");
}

TEST_F(OutputRuleTest, LinkToNothingIsThereAlready) {
  const fs::path link = folder_.path() / "later.uff";
  fs::create_symlink("nowhere.uff", link);
  EXPECT_TRUE(holds(refusal(link, false), "is there already"));
  EXPECT_EQ(refusal(link, true), "");
}

TEST_F(OutputRuleTest, TwoOutputsTakeTwoFiles) {
  const OutputRule rule;
  const fs::path one = folder_.path() / "a.uff";
  EXPECT_NO_THROW(rule.check({one, folder_.path() / "b.uff"}));
  EXPECT_THROW(rule.check({one, folder_.path() / "." / "a.uff"}), InputError);
}

// Told before the work, not when it is to be written.
TEST_F(OutputRuleTest, OutputIsAFileInAFolderThatIsThere) {
  const OutputRule rule;
  const fs::path folder = folder_.path();
  EXPECT_NO_THROW(
      rule.check(std::vector<fs::path>{"in-the-working-folder.uff"}));
  EXPECT_NO_THROW(rule.check(std::vector{folder / "a.uff"}));
  for (const fs::path& name :
       {fs::path(), folder, folder / "", folder / "no" / "a.uff"}) {
    EXPECT_THROW(rule.check(std::vector{name}), InputError) << name;
  }
  const auto said = [&rule](const fs::path& name) -> std::string {
    try {
      rule.check(std::vector{name});
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_TRUE(holds(said(folder / "no" / "a.uff"), "its folder is not there"));
  EXPECT_TRUE(holds(said(input_ / "a.uff"), "its folder is a file"));
}

// Opening it would wait for whatever reads it.
TEST_F(OutputRuleTest, APipeByNameIsNoOutput) {
  const fs::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const OutputRule rule{{}, true};
  try {
    rule.check(std::vector<fs::path>{pipe});
    FAIL() << "a pipe was taken";
  } catch (const InputError& error) {
    EXPECT_TRUE(holds(error.what(), "is a pipe"));
  }
  EXPECT_NO_THROW(rule.check(std::vector<fs::path>{"/dev/stdout"}));
}

TEST_F(OutputRuleTest, FreeNameIsNoInputThatIsNotThere) {
  const OutputRule rule{{folder_.path() / "gone.wav"}, false};
  EXPECT_EQ(rule.free_name(folder_.path() / "gone.wav").filename(),
            "gone-2.wav");
  EXPECT_EQ(rule.free_name("no-such-file.md"), "no-such-file.md");
  EXPECT_EQ(rule.free_name("no-such-file.md",
                           [](const fs::path& name) {
                             return name.stem() == "no-such-file-3";
                           }),
            "no-such-file-3.md");
}

}  // namespace
}  // namespace tapfit::acquisition
