// A report's files: what is replaced, and what is left where one cannot be.
#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/tui/support/two_effects.hpp"
#include "tui/report/session_report.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace tapfit::tui {
namespace {

using testing::data_of_two_effects;

class WrittenReport : public ::testing::Test {
 protected:
  WrittenReport() { std::filesystem::create_directory(path("r-files")); }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const {
    return folder_.path() / name;
  }
  void write(const acquisition::OutputRule& rule) const {
    write_report(report_document(data_of_two_effects()), path("r.md"), rule);
  }
  [[nodiscard]] std::uintmax_t size_of(const std::string& name) const {
    return std::filesystem::file_size(path(name));
  }

  ::tapfit::testing::TemporaryFolder folder_;
};

TEST_F(WrittenReport, ReplacesPicturesOnlyWhereTheRuleLetsIt) {
  folder_.write("r-files/frf.svg", "mine");
  EXPECT_THROW(write({{}, false}), InputError);
  EXPECT_THROW(write({{path("r-files/frf.svg")}, true}), InputError);
  EXPECT_EQ(size_of("r-files/frf.svg"), 4U);
  EXPECT_FALSE(std::filesystem::exists(path("r.md")));
  write({{}, true});
  EXPECT_GT(size_of("r-files/frf.svg"), 4U);
  EXPECT_GT(size_of("r.md"), 4U);
}

// An INCLUDE that is not there yet, for example.
TEST_F(WrittenReport, PutsNoPictureAtAnInputsPlace) {
  EXPECT_THROW(write({{path("r-files/error-after.svg")}, true}), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(path("r-files")));
  EXPECT_FALSE(std::filesystem::exists(path("r.md")));
}

// A name that has no room for the ending of what is not finished: the report
// cannot be written, its pictures could.
TEST_F(WrittenReport, LeavesNoPictureWithoutItsText) {
  const std::string stem(245, 'x');
  const std::filesystem::path pictures = path(stem + "-files");
  std::filesystem::create_directory(pictures);
  EXPECT_THROW(
      write_report(
          report_document(data_of_two_effects()), path(stem + ".md"), {}),
      InputError);
  EXPECT_TRUE(std::filesystem::is_empty(pictures));
}

}  // namespace
}  // namespace tapfit::tui
