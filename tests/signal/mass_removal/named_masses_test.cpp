#include "signal/mass_removal/named_masses.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/signal/support/known_masses.hpp"

#include <gtest/gtest.h>

namespace tapfit::signal {
namespace {

TEST(NamedMasses, ReadsWords) {
  EXPECT_EQ(parse_free("acc1")->what, "acc1");
  EXPECT_FALSE(parse_free("acc1")->kg.has_value());
  EXPECT_DOUBLE_EQ(*parse_free("acc1=0.02")->kg, 0.02);
  EXPECT_DOUBLE_EQ(parse_free("acc1=0.02,sd=0.001")->sd_kg, 0.001);
  EXPECT_DOUBLE_EQ(parse_free("all,sd=0.001")->sd_kg, 0.001);
  for (const char* wrong : {"",
                            "=0.02",
                            "acc1=",
                            "acc1=x",
                            "acc1=-1",
                            "acc1=0",
                            "acc1,se=1",
                            "acc1=0.02,sd=",
                            "acc1=0.02,sd=-1",
                            "acc1=nan",
                            "acc1=inf"}) {
    EXPECT_FALSE(parse_free(wrong).has_value()) << wrong;
  }
}

TEST(NamedMasses, TakesTheStatedMassWhereNoneIsGiven) {
  for (const char* word : {"acc1", "all"}) {
    const auto loaded =
        masses_to_free(bundle_with_masses(), frfs_with_masses(), {word});
    ASSERT_EQ(loaded.masses.size(), 1U);
    EXPECT_DOUBLE_EQ(loaded.masses[0].kg, 0.02);
    ASSERT_EQ(loaded.loads[0].size(), 1U);
  }
}

TEST(NamedMasses, SaysWhatIsWrongWithAName) {
  const auto free = [](const std::vector<std::string>& words) {
    (void)masses_to_free(bundle_with_masses(), frfs_with_masses(), words);
  };
  EXPECT_THROW(free({"acc9"}), InputError);
  EXPECT_THROW(free({"acc2"}), InputError);  // no mass stated
  EXPECT_THROW(free({"hammer=0.1"}), InputError);
  EXPECT_THROW(free({"acc1", "12Z=0.02"}), InputError);
}

}  // namespace
}  // namespace tapfit::signal
