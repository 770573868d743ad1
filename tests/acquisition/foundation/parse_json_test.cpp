// JSON of a user's: what is wrong with it, and in which line and column.
#include "acquisition/foundation/parse_json.hpp"

#include "tests/support/matchers.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit {
namespace {

TEST(ParseJson, NamesThePlaceOfWhatIsMissing) {
  EXPECT_THAT([] { (void)parse_json("{\n \"a\": 1\n \"b\": 2}", "x.json"); },
              Refuses("x.json:3:4: syntax error"));
}

TEST(ParseJson, NamesANumberThatIsTooLarge) {
  EXPECT_THAT([] { (void)parse_json("{\n \"a\": -1e999}", "x.json"); },
              Refuses("x.json:2:7: the number -1e999 is larger"));
}

}  // namespace
}  // namespace tapfit
