#include "tui/screen/escape_sequence.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tapfit::tui {
namespace {

struct Read {
  EscapeSequence sequence;
  std::u32string rest;
};

/// @param text what follows the Esc
Read read(std::u32string text) {
  std::size_t at = 0;
  const auto next = [&]() -> std::optional<char32_t> {
    if (at == text.size()) return std::nullopt;
    return text[at++];
  };
  const EscapeSequence sequence = read_escape_sequence(next);
  return {sequence, text.substr(at)};
}

TEST(EscapeSequence, EscByItselfIsTheKey) {
  EXPECT_FALSE(read(U"").sequence.is_one);
  // As scripts send it with the next key at once.
  const Read with_key = read(U"q7");
  EXPECT_FALSE(with_key.sequence.is_one);
  EXPECT_EQ(with_key.sequence.unread, U"q");
  EXPECT_EQ(with_key.rest, U"7");
}

TEST(EscapeSequence, KnowsTheKeysOfOtherTerminals) {
  for (const auto& [text, key] : {std::pair{U"[1~", keys::home},
                                  {U"[4~", keys::end},
                                  {U"[7~", keys::home},
                                  {U"OF", keys::end},
                                  {U"OA", keys::up},
                                  {U"[B", keys::down},
                                  {U"[6~", keys::page_down}}) {
    const Read found = read(std::u32string(text) + U"q");
    ASSERT_TRUE(found.sequence.key);
    EXPECT_EQ(found.sequence.key->code, key);
    EXPECT_EQ(found.rest, U"q");
  }
}

TEST(EscapeSequence, TakesWhatIsUnknownWhole) {
  for (const char32_t* text : {U"[97;5u",     // a key with modifiers
                               U"[24;1R",     // where the cursor is
                               U"[?62;1;6c",  // what the terminal can do
                               U"[I",         // focus
                               U"[200~3q\n\033[201~",  // pasted
                               U"]11;rgb:0000/0000/0000\033\\",
                               U"]11;rgb:0000/0000/0000\a",
                               U"P1+r544e\033\\"}) {
    const Read found = read(std::u32string(text) + U"q");
    EXPECT_TRUE(found.sequence.is_one);
    EXPECT_FALSE(found.sequence.key);
    EXPECT_EQ(found.rest, U"q");
  }
  // One that is cut off ends where nothing more comes.
  EXPECT_TRUE(read(U"[1;").sequence.is_one);
}

// "Esc _" and "Esc ]" begin a string, but so do two keys pressed at once.
TEST(EscapeSequence, LosesNoKeyThatFollowsTheEscAtOnce) {
  for (const char32_t* keys : {U"_5", U"]", U"P", U"X1", U"^2"}) {
    const Read typed = read(keys);
    EXPECT_FALSE(typed.sequence.is_one);
    EXPECT_EQ(typed.sequence.unread, keys);
  }
  // No hand is as fast.
  EXPECT_TRUE(read(U"]11;" + std::u32string(40, U'f')).sequence.is_one);
}

}  // namespace
}  // namespace tapfit::tui
