// What is written as dataset 58, read back and by its columns.
#include "acquisition/foundation/input_error.hpp"
#include "tests/signal/support/some_frfs.hpp"
#include "tests/support/matchers.hpp"

#include <sstream>

namespace tapfit::signal {
namespace {

using testing::some_set;
using testing::written;

void expect_same(const FrfSet& a, const FrfSet& b, double lines_to) {
  ASSERT_EQ(a.lines(), b.lines());
  EXPECT_LT((a.s - b.s).cwiseAbs().maxCoeff(), lines_to);
  ASSERT_EQ(a.frfs.size(), b.frfs.size());
  for (std::size_t i = 0; i < a.frfs.size(); ++i) {
    EXPECT_EQ(name(a.frfs[i]), name(b.frfs[i]));
    // Twelve decimals are written.
    EXPECT_LT((a.frfs[i].H - b.frfs[i].H).norm(), 1e-11 * a.frfs[i].H.norm());
  }
}

TEST(Uff58, ReadsBackWhatItWrote) {
  for (const double sigma : {0.0, 0.3711}) {
    const FrfSet set = some_set(sigma);
    expect_same(set, read_frfs_uff_text(written(set), "x").set, 1e-13);
  }
}

// Written as mobility or receptance, read as the accelerance it was.
TEST(Uff58, WritesEveryForm) {
  const FrfSet set = some_set(0.3711);
  for (const FrfForm form : {FrfForm::Mobility, FrfForm::Receptance}) {
    std::ostringstream out;
    write_frfs_uff(set, "A test", out, form);
    expect_same(set, read_frfs_uff_text(out.str(), "x").set, 1e-13);
  }
}

TEST(Uff58, TakesTheWindowFromItsQualifier) {
  std::string text = written(some_set(0.3711));
  for (std::size_t at = text.find("SIGMA"); at != std::string::npos;
       at = text.find("SIGMA")) {
    text.replace(at, 5, "other");
  }
  // Eight digits stand in a 1858.
  EXPECT_NEAR(read_frfs_uff_text(text, "x").set.s(0).real(), 0.3711, 1e-8);
}

TEST(Uff58, UnevenLinesKeepSixDigits) {
  const FrfSet set = some_set(2.0, false);
  expect_same(set, read_frfs_uff_text(written(set), "x").set, 1e-3);
}

TEST(Uff58, TakesCarriageReturns) {
  const FrfSet set = some_set(0.0);
  std::string text;
  for (const char c : written(set)) {
    if (c == '\n') text += '\r';
    text += c;
  }
  expect_same(set, read_frfs_uff_text(text, "x").set, 1e-13);
}

TEST(Uff58, KeepsItsColumns) {
  // The columns of record 6 and 7, by the format's definition.
  const std::string text = written(some_set(0.0));
  EXPECT_THAT(
      text,
      HasSubstr("\n    4         1    0         0 NONE              12   3"
                " NONE               3  -1\n"));
  EXPECT_THAT(text,
              HasSubstr("\n         6         7         1  3.33333E-01  "
                        "1.42857E-01  0.00000E+00\n"));
  EXPECT_THAT(
      text,
      HasSubstr("\n        12    0    0    0 Acceleration         m/s^2"));
  EXPECT_LT(text.find("   164\n"), text.find("    58\n"));
}

TEST(Uff58, WritesTheWindowAsQualifier) {
  EXPECT_THAT(written(some_set(0.0)), Not(HasSubstr("  1858\n")));
  const std::string text = written(some_set(0.25));
  EXPECT_THAT(text, HasSubstr("  1858\n"));
  EXPECT_THAT(text, HasSubstr("  2.5000000E-01\n"));
  FrfSet mixed = some_set(0.25);
  mixed.s(2) += 1.0;
  EXPECT_THROW((void)written(mixed), InputError);
}

}  // namespace
}  // namespace tapfit::signal
