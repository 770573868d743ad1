// What is written on a key: beside an input, and over another file after a y.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/tui/support/play.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

class Writing : public ::testing::Test {
 protected:
  /// Writes over a file that is there, then presses the keys.
  [[nodiscard]] std::string answered(const std::string& keys) const {
    return played(
        fmt::format("wait\n:report {}<Enter>\n{}wait", file_.string(), keys),
        {300, 24});
  }

  ::tapfit::testing::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.write("r.md", "older");
};

TEST_F(Writing, AsksBeforeAFileIsReplaced) {
  EXPECT_TRUE(
      holds(answered(""),
            "r.md is there: y replaces it, n writes r-2.md, Esc neither"));
  EXPECT_TRUE(holds(answered("y\n"), "written: " + file_.string()));
  const std::string beside = "written: " + (folder_.path() / "r-2.md").string();
  EXPECT_TRUE(holds(answered("n\n"), beside));
  EXPECT_TRUE(holds(answered("<Enter>\n"), beside));
  for (const char* key : {"<Esc>\n", "x\n", "2\n"}) {
    const std::string seen = answered(key);
    EXPECT_TRUE(holds(seen, "nothing written")) << key << seen;
    EXPECT_FALSE(holds(seen, "written: ")) << key << seen;
  }
}

// They are replaced with it.
TEST_F(Writing, AsksBeforePicturesAreReplaced) {
  std::filesystem::remove(file_);
  std::filesystem::create_directory(folder_.path() / "r-files");
  folder_.write("r-files/frf.svg", "mine");
  std::filesystem::create_directory(folder_.path() / "r-2-files");
  EXPECT_TRUE(holds(
      answered(""),
      "r-files/frf.svg is there: y replaces it, n writes r-3.md, Esc neither"));
  EXPECT_TRUE(holds(answered("<Esc>\n"), "nothing written"));
}

TEST_F(Writing, AsksInTheWidthThatThereIs) {
  const auto file = folder_.write(std::string(60, 'x') + ".md", "older");
  const std::string seen =
      played(fmt::format("wait\n:report {}<Enter>\n", file.string()));
  expect_fits(seen, 80);
  EXPECT_TRUE(holds(seen, "is there: y replaces it")) << seen;
}

TEST_F(Writing, RefusesAReportThatIsNeitherHtmlNorMarkdown) {
  const std::string seen = played("wait\n:report x.pdf<Enter>\nwait");
  EXPECT_TRUE(holds(
      seen, "a report is HTML or Markdown, not .pdf: name it .html or .md"))
      << seen;
  EXPECT_FALSE(holds(seen, "written: "));
}

// The bundle's FRFs are measured.uff, the name that the key writes.
TEST_F(Writing, GoesBesideAnInput) {
  FakeOptions options;
  options.ready_frfs = true;
  const std::string seen = played("7\nwait\nf\nwait", {}, options);
  EXPECT_TRUE(holds(seen,
                    "measured.uff is an input and stays; written: "
                    "made-up/measured-2.uff"))
      << seen;
}

}  // namespace
}  // namespace tapfit::tui
