// What stands in a deck's lines besides cards.
#include "updating/structure/cards/bulk_lines.hpp"

#include "tests/updating/support/deck_support.hpp"

#include <gmock/gmock.h>

namespace tapfit::structure {
namespace {

// Names of cards and matrices stand in what the program says of a deck; the
// deck that is written from it is as it was.
TEST(BulkLines, HoldNoControlCharacters) {
  const std::string card = "FOO\x1b]0;x\x07,1";
  const DeckLines lines =
      read_deck_lines(write_text("model.bdf", "GRID,1\n" + card + "\n"));
  ASSERT_EQ(lines.bulk.size(), 2U);
  EXPECT_EQ(lines.bulk[1].text, "FOO?]0;x?,1");
  EXPECT_EQ(lines.all[1], card);
}

// As old programs wrote them, and mixed.
TEST(BulkLines, EndInReturnsToo) {
  for (const char* text : {"$ a\rGRID,1\rGRID,2\r",
                           "$ a\r\nGRID,1\rGRID,2\r\n",
                           "$ a\nGRID,1\r\nGRID,2"}) {
    const DeckLines lines = read_deck_lines(write_text("model.bdf", text));
    ASSERT_EQ(lines.bulk.size(), 2U) << text;
    EXPECT_EQ(lines.bulk[1].text, "GRID,2");
    EXPECT_EQ(lines.bulk[1].where, "model.bdf:3");
  }
}

}  // namespace
}  // namespace tapfit::structure
