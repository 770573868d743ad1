// Keywords, options and data lines as the deck has them.
#include "updating/structure/abaqus/keyword_block.hpp"

#include "tests/support/matchers.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

std::vector<Keyword> blocks(const std::vector<std::string>& texts) {
  std::vector<PlacedLine> lines;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const int number = static_cast<int>(k) + 1;
    lines.push_back({texts[k], "a.inp:" + std::to_string(number), number});
  }
  return keyword_blocks(lines);
}

TEST(KeywordBlock, OptionsAreTakenWithoutBlanksAndQuotes) {
  const auto found = blocks({"> above the first keyword",
                             "*Solid  Section , ElSet = \"My Set\", REF NODE=3",
                             "** a comment",
                             "",
                             " 1, 2.5 , x,",
                             "4"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "SOLIDSECTION");
  EXPECT_EQ(found[0].shown, "SOLID SECTION");
  EXPECT_EQ(found[0].option("ELSET"), "MY SET");
  EXPECT_EQ(found[0].option("REFNODE"), "3");
  EXPECT_TRUE(found[0].has("REFNODE"));
  ASSERT_EQ(found[0].lines.size(), 2U);
  EXPECT_EQ(found[0].lines[0].fields,
            (std::vector<std::string>{"1", "2.5", "x"}));
  EXPECT_TRUE(found[0].lines[0].continues);
  EXPECT_FALSE(found[0].lines[1].continues);
  EXPECT_EQ(found[0].lines[1].place.where, "a.inp:6");
}

TEST(KeywordBlock, KeywordLineGoesOnBehindAComma) {
  const auto found = blocks({"*ELEMENT, TYPE=S4,", "ELSET=P", "1, 1, 2, 3, 4"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].option("ELSET"), "P");
  EXPECT_EQ(found[0].lines.size(), 1U);
}

// A comma too many: numbers are no options.
TEST(KeywordBlock, DataBehindACommaAreData) {
  const auto found =
      blocks({"*NODE, NSET=A,", "1, 0., 0., 0.", "2, 1., 0., 0."});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].lines.size(), 2U);
}

TEST(KeywordBlock, StepsAreCounted) {
  const auto found =
      blocks({"*NODE", "*STEP", "*STATIC", "*END STEP", "*STEP"});
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[0].step, 0);
  EXPECT_EQ(found[2].step, 1);
  EXPECT_EQ(found[4].step, 2);
}

TEST(KeywordBlock, NumbersHaveExponentsOfEOrD) {
  const auto found =
      blocks({"*NODE", "1, 1.5D0, -2.d-3, +3e2, 1.e5, 1e400, x"});
  const DataLine& line = found.at(0).lines.at(0);
  EXPECT_EQ(number_in(line, 1, "x"), 1.5);
  EXPECT_EQ(number_in(line, 2, "x"), -2e-3);
  EXPECT_EQ(number_in(line, 3, "x"), 300.0);
  EXPECT_EQ(number_in(line, 4, "x"), 1e5);
  EXPECT_EQ(number_or(line, 9, 7.0, "x"), 7.0);
  EXPECT_THAT([&] { static_cast<void>(number_in(line, 5, "x")); },
              Refuses("a number is needed"));
  EXPECT_THAT([&] { static_cast<void>(number_in(line, 6, "x")); },
              Refuses("a number is needed"));
  EXPECT_THAT([&] { static_cast<void>(integer_in(line, 1, "id")); },
              Refuses("an integer is needed"));
}

TEST(KeywordBlock, IncludeNamesItsFile) {
  EXPECT_EQ(included_by_keyword("*Include, Input=parts/a.inp"), "parts/a.inp");
  EXPECT_EQ(included_by_keyword("*INCLUDE,INPUT=\"a b.inp\""), "a b.inp");
  EXPECT_FALSE(included_by_keyword("*NODE, INPUT=a.inp"));
  EXPECT_FALSE(included_by_keyword("*INCLUDE, INPUT="));
  EXPECT_FALSE(included_by_keyword("** *INCLUDE, INPUT=a.inp"));
}

}  // namespace
}  // namespace tapfit::structure
