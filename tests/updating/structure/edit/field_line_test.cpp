// Lines stay in their form: every byte that is not written anew is compared.
#include "updating/structure/edit/field_line.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/edit/edit_cards.hpp"
#include "updating/structure/edit/rescale_cards.hpp"

namespace tapfit::structure {
namespace {

TEST(FieldLine, KeepsColumnsCommasAndComments) {
  FieldLine small = FieldLine::of_card("MAT1    1         7.+10\t\t.3  $ x");
  small.set(2, "7.12345678E+10");
  EXPECT_EQ(small.text(), "MAT1    1       71235.+6        .3 $ x");
  FieldLine right = FieldLine::of_card("PROD           3       1    2.-4");
  right.set(3, "2.2E-4");
  EXPECT_EQ(right.text(), "PROD           3       1  2.2E-4");
  FieldLine large = FieldLine::of_card("MAT1*   1               7.+10");
  large.set(2, "7.12345678E+10");
  large.set(4, ".3");
  EXPECT_EQ(large.text(),
            "MAT1*   1               7.12345678E+10                  .3");
  FieldLine free = FieldLine::of_card("MAT1, 1, 7.+10,,.3,2700. $ x");
  free.set(2, "7.12345678E+10");
  EXPECT_EQ(free.text(), "MAT1, 1, 7.12345678E+10,,.3,2700. $ x");
  FieldLine keyword = FieldLine::of_keyword(" 2.1E11, 0.3, $5");
  keyword.set(0, "2.2E11");
  EXPECT_EQ(keyword.text(), " 2.2E11, 0.3, $5");
}

// As near as eight characters let it: five digits of a modulus.
TEST(FieldLine, GivesNumbersTheDigitsThatHaveRoom) {
  EXPECT_EQ(real_in(7.1234567e10, 8), "71235.+6");
  EXPECT_EQ(real_in(-7.1234567e10, 8), "-7123.+7");
  EXPECT_EQ(real_in(2701.2346, 8), "2701.235");
  EXPECT_EQ(real_in(7.0, 8), "7.");
  EXPECT_EQ(real_in(3.1234567e-3, 8), "31235.-7");
  for (double value = 1.23456789e-8; value < 1e13; value *= 3.7) {
    const std::string text = real_in(value, 8);
    EXPECT_LE(text.size(), 8U) << text;
    EXPECT_NEAR(parse_real(text).value_or(0.0), value, 5e-5 * value) << text;
  }
}

std::vector<std::string> stiffer(const std::string& cards,
                                 const CardScale& scale) {
  std::vector<bool> done;
  const std::vector<CardScale> scales = {scale};
  return edit_cards(write_text("in.bdf", cards), {rescale_cards(scales, done)});
}

TEST(FieldLine, CardsStayInTheFormTheyCameIn) {
  const CardScale twice{"MAT1", 1, {2}, 2.0};
  using Lines = std::vector<std::string>;
  EXPECT_EQ(stiffer("MAT1    1       7.+10           .3      2700.\n", twice),
            (Lines{"$ was: MAT1    1       7.+10           .3      2700.",
                   "MAT1    1       1.4+11          .3      2700."}));
  EXPECT_EQ(stiffer("MAT1,1,7.+10,,.3,2700.\n", twice),
            (Lines{"$ was: MAT1,1,7.+10,,.3,2700.",
                   "MAT1,1,1.40000000E+11,,.3,2700."}));
  EXPECT_EQ(stiffer("MAT1*   1               7.+10\n*       2700.\n", twice),
            (Lines{"$ was: MAT1*   1               7.+10",
                   "$ was: *       2700.",
                   "MAT1*   1               1.40000000E+11",
                   "*       2700."}));
}

// A field on a line that the card had not.
TEST(FieldLine, CardsGoOnInTheirForm) {
  CardScale shear{"PBAR", 2, {17, 18}};
  shear.value = 0.5;
  const std::vector<std::string> lines =
      stiffer("PBAR    2       1       1.-4    1.-8    2.-8    3.-8\n", shear);
  EXPECT_EQ(lines,
            (std::vector<std::string>{
                "$ was: PBAR    2       1       1.-4    1.-8    2.-8    3.-8",
                "PBAR    2       1       1.-4    1.-8    2.-8    3.-8",
                "+",
                "+       0.5     0.5"}));
  EXPECT_EQ(stiffer("PBAR,2,1,1.-4,1.-8\n", shear),
            (std::vector<std::string>{"$ was: PBAR,2,1,1.-4,1.-8",
                                      "PBAR,2,1,1.-4,1.-8",
                                      ",",
                                      ",5.00000000E-01,5.00000000E-01"}));
}

}  // namespace
}  // namespace tapfit::structure
