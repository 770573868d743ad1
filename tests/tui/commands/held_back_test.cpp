#include "tui/commands/held_back.hpp"

#include "tui/commands/update_command.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::tui {
namespace {

class HeldBack : public ::testing::Test {
 protected:
  HeldBack() {
    structure::Material metal;
    metal.id = 1;
    metal.E = 7e10;
    deck_.materials[1] = metal;
    bundle_.uncertain = {{"material", 1, "E", 1.0}};
    arrived_.added = "added-mass";
    arrived_.converged = true;
  }
  [[nodiscard]] std::vector<std::string> held(
      const std::vector<updating::Estimate>& parameters) const {
    return held_back(deck_, bundle_, parameters, {arrived_});
  }
  static updating::Estimate modulus(double value) {
    return {"E:1", value, 1e8, value - 2e8, value + 2e8, "Pa"};
  }

  structure::Deck deck_;
  acquisition::TestBundle bundle_;
  updating::UpdateRecord arrived_;
};

// One percent is all the prior gives away willingly.
TEST_F(HeldBack, ByAPriorThatIsNarrow) {
  EXPECT_TRUE(held({modulus(7.1e10)}).empty());
  const std::vector<std::string> texts =
      held({modulus(7e10 * std::exp(-0.03))});
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(texts[0].find("E:1 ended 3.0 standard deviations of its prior "
                          "below"),
            std::string::npos)
      << texts[0];
}

TEST_F(HeldBack, ByABound) {
  EXPECT_TRUE(held({{"added-mass mass_kg", 0.1, 0.01, 0.08, 0.12}}).empty());
  const auto texts =
      held({{"added-mass mass_kg", 0.3, 0.01, 0.28, 0.3, "", true}});
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(texts[0].find("mass_kg ended at its upper bound, 0.3"),
            std::string::npos)
      << texts[0];
}

TEST_F(HeldBack, ByAFitThatDidNotArrive) {
  updating::UpdateRecord held = arrived_;
  held.where.node = 7;
  held.converged = false;
  held.message = "held by lambda";
  const auto texts = held_back(deck_, bundle_, {}, {arrived_, held});
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(texts[0].find("(held by lambda)"), std::string::npos) << texts[0];
}

TEST_F(HeldBack, IsNamedBeforeAnythingIsSaidToBeMissing) {
  updating::Comparison comparison;
  comparison.floor = 0.01;
  const updating::Rung base{
      .added = "base", .where = {}, .error = 0.5, .parameters = {}};
  const auto warning = [&](const std::vector<std::string>& held) {
    return diagnosis_of_named({base}, comparison, {}, held).warnings.at(0);
  };
  EXPECT_NE(warning({}).find("0.01: something else is missing"),
            std::string::npos);
  EXPECT_NE(warning({"A ended at its bound"})
                .find("0.01: A ended at its bound; or something else"),
            std::string::npos);
}

}  // namespace
}  // namespace tapfit::tui
