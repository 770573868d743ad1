#include "updating/diagnosis/stepwise_selection.hpp"

#include "tests/updating/support/hidden_in_plate.hpp"
#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tapfit::updating {
namespace {

class StepwiseSelectionTest : public support::HiddenInPlate {
 protected:
  static EffectInstance at(const std::string& kind, int grid, double p) {
    Location where;
    where.node = grid;
    return {&effects::find(kind), where, {p}};
  }
};

// Masses of a gram all over the plate, which no effect explains, and a floor
// that knows nothing of them: what leads leaves so much that the first of a
// pair is tried in its place.
TEST_F(StepwiseSelectionTest, WhatLeadsStaysWhereNoSecondFollows) {
  hide({at("ground-spring", 31, 3000.0),
        at("added-mass", 14, 0.001),
        at("added-mass", 21, 0.001),
        at("added-mass", 29, 0.001),
        at("added-mass", 43, 0.001)});
  DiagnoseOptions options;
  options.floor = options.floor_noise = 1e-4;
  StepwiseSelection selection(*fitter_, {}, options, {});
  ASSERT_TRUE(selection.step(true, {}));
  ASSERT_NE(selection.chosen().front().name, "ground-spring");
  const double of_pair = selection.current().result.error;
  ASSERT_FALSE(selection.step(false, {}));
  EXPECT_TRUE(selection.settle());
  ASSERT_EQ(selection.chosen().size(), 1U);
  EXPECT_EQ(selection.chosen().front().name, "ground-spring");
  EXPECT_EQ(selection.current().effects.front().where.node, 31);
  EXPECT_LT(selection.current().result.error, 0.5 * of_pair);
  EXPECT_EQ(selection.held_out_error(),
            selection.candidates().front().held_out_error);
  EXPECT_FALSE(selection.settle());  // once
}

}  // namespace
}  // namespace tapfit::updating
