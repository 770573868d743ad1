// What goes with a report: of Markdown, its pictures.
#include "updating/export/report_files.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

class ReportFiles : public ::testing::Test {
 protected:
  [[nodiscard]] std::string refusal(const acquisition::OutputRule& rule) const {
    try {
      check_report(rule, folder_.path() / "r.md");
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  fs::path picture(const std::string& in) {
    fs::create_directories(folder_.path() / in);
    return folder_.write(in + "/frf.svg", "mine");
  }

  ::tapfit::testing::TemporaryFolder folder_;
};

TEST_F(ReportFiles, OfMarkdownHaveAFolder) {
  EXPECT_EQ(pictures_folder("a/r.md"), "a/r-files");
  EXPECT_EQ(pictures_folder("r.markdown"), "r-files");
  EXPECT_EQ(pictures_folder("a/r.html"), std::nullopt);
}

TEST_F(ReportFiles, AreNamedAsWhatTheyHold) {
  for (const char* name : {"r", "r.html", "r.htm", "r.md", "a.b/r.markdown"}) {
    EXPECT_EQ(report_name_fault(name), "") << name;
  }
  EXPECT_EQ(report_name_fault("r.pdf"),
            "a report is HTML or Markdown, not .pdf");
  EXPECT_THROW(check_report({}, folder_.path() / "r.txt"), InputError);
}

TEST_F(ReportFiles, AreWhatIsThere) {
  const fs::path report = folder_.path() / "r.md";
  EXPECT_EQ(report_files(report), std::vector<fs::path>{report});
  const fs::path there = picture("r-files");
  EXPECT_EQ(report_files(report), (std::vector<fs::path>{report, there}));
  EXPECT_EQ(report_files(folder_.path() / "r.html").size(), 1U);
}

TEST_F(ReportFiles, PicturesAreReplacedOnlyWhereThatIsAskedFor) {
  const fs::path there = picture("r-files");
  picture("r-2-files");
  const std::string said = refusal({{}, false});
  EXPECT_NE(said.find(there.string()), std::string::npos) << said;
  EXPECT_NE(said.find("such as r-3.md"), std::string::npos) << said;
  EXPECT_EQ(refusal({{}, true}), "");
  EXPECT_NE(refusal({{there}, true}).find("is an input"), std::string::npos);
}

// The folder may lead elsewhere.
TEST_F(ReportFiles, BehindALinkAreFilesAsAnyOther) {
  const fs::path there = picture("elsewhere");
  fs::create_directory_symlink("elsewhere", folder_.path() / "r-files");
  EXPECT_NE(refusal({{}, false}), "");
  EXPECT_NE(refusal({{there}, true}).find("is an input"), std::string::npos);
}

}  // namespace
}  // namespace tapfit::updating
