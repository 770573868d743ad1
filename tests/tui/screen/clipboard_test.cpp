#include "tui/screen/clipboard.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

// RFC 4648, section 10.
TEST(Clipboard, TakesTextInBase64) {
  const auto of = [](std::string_view text) {
    const std::string whole = clipboard_sequence(text);
    EXPECT_TRUE(whole.starts_with("\033]52;c;"));
    EXPECT_TRUE(whole.ends_with("\a"));
    return whole.substr(7, whole.size() - 8);
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foob"), "Zm9vYg==");
  EXPECT_EQ(of("fooba"), "Zm9vYmE=");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(of("m/s²"), "bS9zwrI=");
}

}  // namespace
}  // namespace tapfit::tui
