#include "acquisition/bundle/uff_file.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace tapfit::acquisition {
namespace {

TEST(IsUff, IsToldByTheFirstWord) {
  const testing::TemporaryFolder folder;
  EXPECT_TRUE(is_uff(folder.write("a", "    -1\n    58\n")));
  EXPECT_TRUE(is_uff(folder.write("b", "\r\n -1\r\n")));
  for (const char* text : {"", "-", "-12\n", "-1234567\n", "-1,\n", "1 -1\n"}) {
    EXPECT_FALSE(is_uff(folder.write("c", text))) << text;
  }
}

// A GB of zeros is one word: to read it takes seconds.
TEST(IsUff, ReadsNoMoreThanThat) {
  const testing::TemporaryFolder folder;
  const auto file = folder.write("zeros", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30U);  // sparse
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(is_uff(file));
  const std::chrono::duration<double> took =
      std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count(), 0.5);
}

// As of a copy that was not finished; a terabyte takes minutes to look through.
TEST(UffFile, OfZerosIsRefusedAtOnce) {
  const testing::TemporaryFolder folder;
  const auto file = folder.write("holes.uff", "    -1\n    58\n");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40U);  // sparse
  EXPECT_THAT([&] { (void)open_uff(file); },
              Refuses("holes.uff, line 3: a line has more than"));
}

}  // namespace
}  // namespace tapfit::acquisition
