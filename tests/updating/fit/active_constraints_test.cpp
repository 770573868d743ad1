#include "updating/fit/active_constraints.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

std::vector<std::string> held(const std::vector<Estimate>& parameters) {
  return active_constraints({{"E:1", "Pa", 7e10, 0.01}}, parameters);
}

Estimate modulus(double value) {
  return {"E:1", value, 1e8, value - 2e8, value + 2e8, "Pa"};
}

// One percent is all the prior gives away willingly.
TEST(HeldBack, ByAPriorThatIsNarrow) {
  EXPECT_TRUE(held({modulus(7.1e10)}).empty());
  const std::vector<std::string> texts =
      held({modulus(7e10 * std::exp(-0.03))});
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(texts[0].find("E:1 ended 3.0 standard deviations of its prior "
                          "below"),
            std::string::npos)
      << texts[0];
  EXPECT_NE(texts[0].find("`sd_percent` 1 "), std::string::npos) << texts[0];
}

// What no prior is told of is held by none.
TEST(HeldBack, ByNoPriorWhereNoneIsTold) {
  EXPECT_TRUE(
      active_constraints({{"E:1", "Pa", 7e10, 0.0}}, {modulus(7e10)}).empty());
}

TEST(HeldBack, ByABound) {
  EXPECT_TRUE(held({{"added-mass mass_kg", 0.1, 0.01, 0.08, 0.12}}).empty());
  const auto texts =
      held({{"added-mass mass_kg", 0.3, 0.01, 0.28, 0.3, "", true}});
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(texts[0].find("mass_kg ended at its upper bound, 0.3"),
            std::string::npos)
      << texts[0];
}

TEST(HeldBack, IsNamedBeforeWhatMayBeMissing) {
  EXPECT_EQ(what_is_left({}), "something else is missing");
  EXPECT_EQ(what_is_left({"A ended", "B ended"}),
            "A ended; B ended; or something else is missing");
}

}  // namespace
}  // namespace tapfit::updating
