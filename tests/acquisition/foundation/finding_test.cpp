#include "acquisition/foundation/finding.hpp"

#include <gtest/gtest.h>

namespace tapfit {
namespace {

TEST(Finding, HoldsNumbersWithoutPowersOfTen) {
  EXPECT_EQ(in_digits(3187.0, 2), "3200");
  EXPECT_EQ(in_digits(118.0, 2), "120");
  EXPECT_EQ(in_digits(46.2, 2), "46");
  EXPECT_EQ(in_digits(3.226, 3), "3.23");
  EXPECT_EQ(in_digits(9.96, 2), "10");
  EXPECT_EQ(in_digits(0.00042, 2), "0.00042");
  EXPECT_EQ(in_digits(-1200.0, 2), "-1200");
  EXPECT_EQ(in_digits(4.0, 4), "4");
  EXPECT_EQ(in_digits(0.0, 2), "0");
}

}  // namespace
}  // namespace tapfit
