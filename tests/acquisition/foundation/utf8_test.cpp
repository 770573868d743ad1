#include "acquisition/foundation/utf8.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/csv_table.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

TEST(Utf8, StaysAsItIs) {
  for (const char* text : {"", "acc1", "Kraft N\xc3\xa4he", "\xe2\x82\xac"}) {
    EXPECT_EQ(as_utf8(text), text);
  }
}

TEST(Utf8, ElseIsReadAsLatin1) {
  EXPECT_EQ(as_utf8("N\xe4he"), "N\xc3\xa4he");
  EXPECT_EQ(as_utf8("m/s\xb2"), "m/s\xc2\xb2");
  // Cut in the middle of a character.
  EXPECT_EQ(as_utf8("\xc3"), "\xc3\x83");
}

TEST(Utf8, PrintableTextHasNoOddBytes) {
  EXPECT_EQ(printable("m/s\xb2 \xc3\xa4\n"), "m/s\xc2\xb2 \xc3\xa4\n");
  EXPECT_EQ(printable(std::string("a\0b\x1b[2J", 7)), "a?b?[2J");
  // CSI of one byte, and as UTF-8; a character cut in the middle.
  EXPECT_EQ(printable("\x9b"), "?");
  EXPECT_EQ(printable("\xc2\x9b|"), "?|");
  EXPECT_EQ(printable("\xe2\x82"), "\xc3\xa2?");
}

// Which are letters all the same beside others of their block.
TEST(Utf8, PrintableTextReadsAsItStands) {
  EXPECT_EQ(printable("a\xe2\x80\xaeknip.wav"), "a?knip.wav");
  EXPECT_EQ(printable("\xe2\x81\xa6|\xe2\x80\xa8|\xd8\x9c"), "?|?|?");
  EXPECT_EQ(printable("10\xe2\x80\x93"
                      "20 \xe2\x82\xac"),
            "10\xe2\x80\x93"
            "20 \xe2\x82\xac");
}

TEST(Utf8, MessagesShowWhateverIsInTheInput) {
  const InputError error(std::string("\"1\0002\" is no number", 18),
                         "Pr\xfc"
                         "f.csv:2",
                         "correct it");
  EXPECT_STREQ(error.what(),
               "Pr\xc3\xbc"
               "f.csv:2: \"1?2\" is no number (correct it)");
}

TEST(Utf8, ColumnsOfALatin1HeaderAreFoundByName) {
  testing::TemporaryFolder folder;
  const auto file =
      folder.write("test.csv", "t;N\xe4he;acc\n0.0;1.5;2\n0.1;2.5;3\n");
  const Eigen::MatrixXd x = read_csv_columns(file, {"N\xc3\xa4he"}, {});
  EXPECT_EQ(x.col(0), Eigen::Vector2d(1.5, 2.5));
}

}  // namespace
}  // namespace tapfit::acquisition
