#include "updating/diagnosis/diagnosis_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tapfit::updating {
namespace {

const EffectRef mass{"added-mass", {.node = 7}};
const EffectRef joint{"joint", {.nodes = {3, 4}, .variant = "rotation"}};

Diagnosis rich() {
  Diagnosis d;
  d.verdict = "added-mass|joint";
  d.error_base = 1.0 / 3.0;
  d.error_fitted = 0.1;
  d.error_best = 5e-324;
  d.floor = 0.01;
  d.contour = "on \u03c3 + j\u03c9";
  const Estimate estimate{"mass_kg", 0.1, 0.01, 0.08, 0.12, "kg", true};
  d.candidates.push_back({.effect = "added-mass",
                          .where = mass.where,
                          .parameters = {estimate},
                          .probability = 0.7,
                          .error = 0.02,
                          .held_out_error = 0.03,
                          .indistinguishable_from = {joint}});
  d.ladder.push_back({.added = "added-mass|joint",
                      .where = {.elements = {1, 2}, .channels = {"acc1"}},
                      .error = 0.02,
                      .parameters = {estimate},
                      .probability = 0.7,
                      .alike = {joint},
                      .stopped_after = 3});
  d.model_parameters = {estimate};
  d.next.push_back({.one = mass,
                    .other = joint,
                    .hit = {12, 3, -1},
                    .sensor = {4, 1, 1},
                    .channel = "acc1",
                    .moves_sensor = true,
                    .difference = 0.4,
                    .difference_now = 0.1});
  Location moved;
  moved.node = 6;
  moved.nodes = {5};
  moved.channels = {"acc1"};
  moved.runs = {2, 3};
  d.set_up.push_back({.mistake = "point-mislabelled",
                      .where = moved,
                      .probability = 0.9,
                      .error = 0.02,
                      .edit = "runs[1-2].sensors[0].node: 5 -> 6"});
  d.warnings = {"one", "two \"quoted\""};
  const MadeFit made{.effects = {mass, joint},
                     .sizes = {{0.1}, {2.0, 3.0}},
                     .factor = {1.01},
                     .zeta = {0.004, 0.005},
                     .zeta_other = 0.02,
                     .places = 7.0,
                     .kind_share = 1.5};
  d.rivals = {made, {{made, made}, {made}}, {made}};
  d.robustness = {{.change = "prior of E:1 doubled",
                   .verdict = "joint",
                   .verdict_stands = false,
                   .parameters = {estimate},
                   .largest_move_sd = 0.5}};
  return d;
}

// Each field is other than what it is where nothing is said, so that one that
// is forgotten shows in the second text.
TEST(DiagnosisText, GivesEverythingBack) {
  const Diagnosis d = rich();
  const auto text = as_text(d);
  ASSERT_TRUE(text.has_value());
  const auto read = diagnosis_from(*text);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(as_text(*read), text);
  EXPECT_EQ(read->verdict, d.verdict);
  EXPECT_EQ(read->error_base, d.error_base);
  EXPECT_EQ(read->error_best, d.error_best);
  EXPECT_EQ(read->candidates[0].indistinguishable_from,
            d.candidates[0].indistinguishable_from);
  EXPECT_EQ(read->ladder[0].where, d.ladder[0].where);
  EXPECT_EQ(read->ladder[0].stopped_after, 3);
  EXPECT_TRUE(read->ladder[0].parameters[0].at_bound);
  EXPECT_EQ(read->next[0].hit, d.next[0].hit);
  EXPECT_TRUE(read->next[0].moves_sensor);
  EXPECT_EQ(read->set_up[0].where, d.set_up[0].where);
  EXPECT_EQ(read->set_up[0].edit, d.set_up[0].edit);
  EXPECT_EQ(read->warnings, d.warnings);
  EXPECT_EQ(read->rivals.instead[0][1].effects[1], joint);
  EXPECT_EQ(read->rivals.besides[0].sizes[1][1], 3.0);
  EXPECT_FALSE(read->robustness[0].verdict_stands);
}

TEST(DiagnosisText, IsNoneWhereItWouldNotBeTheSame) {
  EXPECT_FALSE(diagnosis_from("").has_value());
  EXPECT_FALSE(diagnosis_from("{\"verdict\": \"none\"}").has_value());
  Diagnosis d = rich();
  d.floor = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(diagnosis_from(as_text(d).value()).has_value());
  d = rich();
  d.warnings = {"\xff"};
  EXPECT_FALSE(as_text(d).has_value());
}

TEST(Describe, NamesAFewPlacesOneByOne) {
  Location where;
  where.elements = {9};
  EXPECT_EQ(describe(where), "element 9");
  where.elements = {9, 10};
  EXPECT_EQ(describe(where), "elements 9, 10");
  where.elements = {9, 10, 11, 12};
  EXPECT_EQ(describe(where), "4 elements (9 ... 12)");
}

}  // namespace
}  // namespace tapfit::updating
