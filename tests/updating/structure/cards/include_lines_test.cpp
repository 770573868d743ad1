// INCLUDE lines that name another file are read as that name.
#include "updating/structure/cards/include_lines.hpp"

#include <gmock/gmock.h>
#include <sstream>

namespace tapfit::structure {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::SizeIs;

std::optional<std::string> read_name(const std::vector<std::string>& lines) {
  std::string text = lines.front();
  std::stringstream others;
  for (std::size_t k = 1; k < lines.size(); ++k) others << lines[k] << '\n';
  int number = 1;
  EXPECT_TRUE(complete_include(others, text, number));
  EXPECT_EQ(number, static_cast<int>(lines.size()));
  return include_name(text);
}

TEST(IncludeLines, KeepWhatStandsBehindTheName) {
  EXPECT_THAT(renamed_include("include 'old.bdf' $ wing", "new.bdf"),
              ElementsAre("INCLUDE 'new.bdf' $ wing"));
  EXPECT_THAT(renamed_include("INCLUDE old.bdf", "new.bdf"),
              ElementsAre("INCLUDE 'new.bdf'"));
}

TEST(IncludeLines, OfANameWithAQuoteHaveTheOtherOne) {
  EXPECT_EQ(read_name(renamed_include("INCLUDE 'a'", "joe's/wing.bdf")),
            "joe's/wing.bdf");
}

// Bulk data has 72 columns of fields, in which the guide parts long names.
TEST(IncludeLines, PartALongNameBehindFolders) {
  std::string name = "..";
  for (int k = 0; k < 30; ++k) name += "/folder-" + std::to_string(k);
  name += "/wing.bdf";
  const std::vector<std::string> lines = renamed_include("INCLUDE 'a'", name);
  EXPECT_GT(lines.size(), 3U);
  EXPECT_THAT(lines, Each(SizeIs(::testing::Le(72U))));
  EXPECT_EQ(read_name(lines), name);
}

// No break is left in a folder's name.
TEST(IncludeLines, LeaveAFolderWholeThatIsLongerThanALine) {
  const std::string name = "a/" + std::string(100, 'x') + "/wing.bdf";
  const std::vector<std::string> lines = renamed_include("INCLUDE 'a'", name);
  EXPECT_THAT(
      lines,
      ElementsAre("INCLUDE 'a/", std::string(100, 'x') + "/", "wing.bdf'"));
  EXPECT_EQ(read_name(lines), name);
}

}  // namespace
}  // namespace tapfit::structure
