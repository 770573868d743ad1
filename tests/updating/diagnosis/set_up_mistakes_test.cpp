// Mistakes of the sheet as part of a diagnosis.
#include "updating/diagnosis/set_up_mistakes.hpp"

#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/diagnosis/effect_forms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

EffectInstance moved(const std::string& channel,
                     int written,
                     int real,
                     const std::vector<int>& runs = {}) {
  Location where;
  where.channels = {channel};
  where.nodes = {written};
  where.node = real;
  where.runs = runs;
  return {&effects::find("point-mislabelled"), where, {}};
}

TEST(SetUpMistakes, HitElsewhereIsNamed) {
  const EffectInstance hidden = moved("hammer", 52, 49);
  const Diagnosis d = PlateExperiment({hidden}, 0.02, 1).diagnose_it();
  EXPECT_EQ(d.verdict, "point-mislabelled");
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, hidden.where);
  EXPECT_EQ(d.set_up[0].edit, "runs[2].hammer.node: 52 -> 49");
  EXPECT_LT(d.error_best, 1.1 * d.floor);
}

// Its FRFs are half of all.
TEST(SetUpMistakes, SensorElsewhereIsNamed) {
  const EffectInstance hidden = moved("acc2", 36, 33);
  const Diagnosis d = PlateExperiment({hidden}, 0.02, 2).diagnose_it();
  EXPECT_EQ(d.verdict, "point-mislabelled");
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, hidden.where);
}

TEST(SetUpMistakes, SensorMovedOnTheWayIsNamedWithItsRuns) {
  const EffectInstance hidden = moved("acc2", 36, 33, {4, 5, 6});
  const Diagnosis d = PlateExperiment({hidden}, 0.02, 3).diagnose_it();
  EXPECT_EQ(d.verdict, "point-mislabelled");
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, hidden.where);
  EXPECT_EQ(d.set_up[0].edit, "runs[3-5].sensors[1].node: 36 -> 33");
}

EffectInstance of_channel(const std::string& name,
                          const std::string& channel,
                          const std::string& variant) {
  Location where;
  where.channels = {channel};
  where.variant = variant;
  return {&effects::find(name), where, {}};
}

TEST(SetUpMistakes, BlowFromTheOtherSideIsNamed) {
  EffectInstance hidden = of_channel("direction-wrong", "hammer", "-Z");
  hidden.where.nodes = {28};
  const Diagnosis d = PlateExperiment({hidden}, 0.02, 6).diagnose_it();
  EXPECT_EQ(d.verdict, "direction-wrong");
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, hidden.where);
  EXPECT_EQ(d.set_up[0].edit, "runs[3].hammer.direction: +Z -> -Z");
}

TEST(SetUpMistakes, UnitsAreNamedWithTheirFactor) {
  for (const char* slip : {"1000", "9.807", "1/4.448", "25.4"}) {
    const EffectInstance hidden = of_channel("unit-factor", "acc2", slip);
    const Diagnosis d = PlateExperiment({hidden}, 0.02, 7).diagnose_it();
    // A gain that is fitted may come as close.
    EXPECT_TRUE(d.verdict.starts_with("unit-factor")) << d.verdict;
    ASSERT_EQ(d.set_up.size(), 1U) << slip;
    EXPECT_EQ(d.set_up[0].where, hidden.where);
    ASSERT_EQ(d.ladder[0].parameters.size(), 1U);
    EXPECT_EQ(d.ladder[0].parameters[0].name, "factor");
  }
}

// Only where a unit does as well.
TEST(SetUpMistakes, GainThatAUnitExplainsIsTheUnit) {
  const auto plain_of = [](const EffectInstance& hidden) {
    const PlateExperiment test({hidden}, 0.02, 12);
    const EffectInstance gain = {
        &effects::find("channel-gain"), {.channels = {"hammer"}}, {0.5}};
    const Fitter& fitter = test.fitter();
    const Fit fit = fitter.fit({gain}, fitter.model_for({gain}));
    return in_plain_form(fit, 0, fitter, {});
  };
  const auto unit = plain_of(of_channel("unit-factor", "hammer", "1/4.448"));
  ASSERT_TRUE(unit);
  EXPECT_EQ(unit->effects[0].where.variant, "1/4.448");
  EXPECT_FALSE(plain_of(
      {&effects::find("channel-gain"), {.channels = {"hammer"}}, {1.3}}));
}

// What makes up for the rest at first comes out as a gain of its own.
TEST(SetUpMistakes, UnitBesideAWrongPointIsNamed) {
  const EffectInstance unit = of_channel("unit-factor", "hammer", "1/4.448");
  const PlateExperiment test({unit, moved("acc2", 36, 33)}, 0.02, 12);
  const Diagnosis d = test.diagnose_it();
  ASSERT_EQ(d.set_up.size(), 2U) << d.verdict;
  for (const SetUpMistake& mistake : d.set_up) {
    const bool point = mistake.mistake == "point-mislabelled";
    EXPECT_TRUE(point || mistake.mistake == "unit-factor") << mistake.mistake;
  }
}

TEST(SetUpMistakes, QuantityAndRangeOfOneRunAreNamed) {
  EffectInstance velocity = of_channel("unit-factor", "acc1", "integrated");
  velocity.where.channels = {"acc1", "acc2"};
  const Diagnosis d = PlateExperiment({velocity}, 0.02, 8).diagnose_it();
  EXPECT_EQ(d.verdict, "unit-factor");
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, velocity.where);
  EffectInstance range = of_channel("unit-factor", "acc1", "3.162");
  range.where.runs = {4};
  const Diagnosis one = PlateExperiment({range}, 0.02, 9).diagnose_it();
  EXPECT_TRUE(one.verdict.starts_with("unit-factor")) << one.verdict;
  ASSERT_EQ(one.ladder.size(), 1U);
  EXPECT_EQ(one.ladder[0].where, range.where);
}

TEST(SetUpMistakes, SupportThatWasNotThereIsNamed) {
  Location where;
  where.nodes = {1, 12, 23, 34, 45};
  where.variant = "free";
  const PlateExperiment test(
      {{&effects::find("support-mismatch"), where, {}}}, 0.02, 10);
  const Diagnosis d = test.diagnose_it();
  EXPECT_TRUE(d.verdict.starts_with("support-mismatch")) << d.verdict;
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, where);
  EXPECT_EQ(d.set_up[0].edit,
            "model: release components 123456 (basic axes) at 5 nodes (1 ... "
            "45)");
}

// Clamped in the test, free in the deck: springs in a row, or a modulus that is
// off, come nowhere near it.
TEST(SetUpMistakes, SupportThatTheDeckLacksIsNamed) {
  Location where;
  where.nodes = {1, 12, 23, 34, 45};
  where.variant = "held";
  const PlateExperiment test({{&effects::find("support-mismatch"), where, {}}},
                             0.02,
                             11,
                             0.008,
                             false);
  const Diagnosis d = test.diagnose_it();
  EXPECT_TRUE(d.verdict.starts_with("support-mismatch")) << d.verdict;
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, where);
  EXPECT_EQ(d.set_up[0].edit,
            "model: hold components 123456 (basic axes) at 5 nodes (1 ... 45)");
  EXPECT_LT(d.error_best, 1.1 * d.floor);
}

// The reverse of a false alarm: the deck is free, and so is the test.
TEST(SetUpMistakes, FreeTestOfAFreeDeckLacksNoSupport) {
  const PlateExperiment test({}, 0.02, 12, 0.008, false);
  const Diagnosis d = test.diagnose_it();
  EXPECT_EQ(d.verdict, "none");
  EXPECT_TRUE(d.set_up.empty());
}

TEST(SetUpMistakes, AreToBeCorrectedOneAfterTheOther) {
  Rung at_33;
  at_33.added = "point-mislabelled";
  at_33.where = moved("acc2", 36, 33).where;
  Rung swapped;
  swapped.added = "channel-swap";
  swapped.where.channels = {"acc1", "acc2"};
  const auto found = set_up_mistakes({at_33, swapped}, support::plate_bundle());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].edit, "runs[0-5].sensors[1].node: 36 -> 33");
  EXPECT_EQ(found[1].edit,
            "runs[0-5].sensors[0].direction: +Z -> -Z; "
            "runs[0-5].sensors[0].node: 11 -> 33; "
            "runs[0-5].sensors[1].direction: -Z -> +Z; "
            "runs[0-5].sensors[1].node: 33 -> 11");
}

TEST(SetUpMistakes, AreFoundBesideAnEffect) {
  Location grid;
  grid.node = 30;
  const PlateExperiment test(
      {{&effects::find("added-mass"), grid, {0.03}}, moved("hammer", 6, 9)},
      0.02,
      4);
  const Diagnosis d = test.diagnose_it();
  EXPECT_TRUE(d.verdict == "point-mislabelled+added-mass" ||
              d.verdict == "added-mass+point-mislabelled")
      << d.verdict;
  ASSERT_EQ(d.set_up.size(), 1U);
  EXPECT_EQ(d.set_up[0].where, moved("hammer", 6, 9).where);
}

// One reading five times the usual scatter, of 8 runs:
// 12.5 - ln 5 - 0.5 - ln 8 = 8.31.
TEST(SetUpMistakes, RunOfAnotherStructureIsNamed) {
  const auto found = run_outliers({{4, 0.4, 0.08}}, 8, 0.03);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].mistake, "run-outlier");
  EXPECT_EQ(found[0].where.runs, std::vector<int>{5});
  EXPECT_NEAR(found[0].probability, 1.0 / (1.0 + std::exp(-8.31)), 1e-6);
  EXPECT_EQ(found[0].error, 0.03);
  EXPECT_EQ(describe(found[0]),
            "run-outlier at run 5: correct runs[4].file, or take runs[4] out");
  EXPECT_EQ(run_outliers({{0, 0.9, 0.0}}, 8, 0.03)[0].probability, 1.0)
      << "without noise";
}

// Of both ends the ratio alone shows: sensors that read 1000 times too much are
// a hammer that reads too little.
TEST(SetUpMistakes, AllSensorsOffByAThousandAreNamed) {
  EffectInstance hidden = of_channel("unit-factor", "acc1", "1000");
  hidden.where.channels = {"acc1", "acc2"};
  EffectInstance hammer = of_channel("unit-factor", "hammer", "1/1000");
  for (const EffectInstance& slip : {hidden, hammer}) {
    const Diagnosis d = PlateExperiment({slip}, 0.02, 13).diagnose_it();
    EXPECT_EQ(d.verdict, "unit-factor");
    ASSERT_EQ(d.set_up.size(), 1U);
    ASSERT_EQ(d.ladder.size(), 1U);
    const auto is = [&](const Location& where) {
      return d.ladder[0].where == where ||
             std::ranges::any_of(d.ladder[0].alike, [&](const EffectRef& ref) {
               return ref.where == where;
             });
    };
    EXPECT_TRUE(is(hidden.where));
    EXPECT_TRUE(is(hammer.where));
  }
}

TEST(SetUpMistakes, AreNoneOnARightSheet) {
  Location grid;
  grid.node = 30;
  const PlateExperiment test(
      {{&effects::find("added-mass"), grid, {0.03}}}, 0.02, 5);
  const Diagnosis d = test.diagnose_it();
  EXPECT_EQ(d.verdict, "added-mass");
  EXPECT_TRUE(d.set_up.empty());
}

// What a fit of the model says of sensors, against their sheet.
TEST(SetUpMistakes, OfASensorsStatedMassAreNamed) {
  acquisition::TestBundle sheet;
  sheet.channels.resize(3);
  sheet.channels[1].name = "acc1";
  sheet.channels[1].mass_kg = 0.1;
  sheet.channels[2].name = "acc2";
  sheet.channels[2].mass_kg = 0.011;
  Rung rung;
  rung.added = "sensor-mass";
  rung.where.channels = {"acc1", "acc2"};
  rung.parameters = {{"mass_kg", 0.01, 0.0005, 0.009, 0.011}};
  Diagnosis d;
  d.verdict = "sensor-mass";
  d.ladder = {rung};
  const auto found = sensor_mass_findings(d, sheet);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].where.channel, "acc1");
  d.ladder[0].parameters = {{"mass_kg.acc1", 0.1, 0.0005, 0.099, 0.101},
                            {"mass_kg.acc2", 0.05, 0.0005, 0.049, 0.051}};
  const auto each = sensor_mass_findings(d, sheet);
  ASSERT_EQ(each.size(), 1U);
  EXPECT_EQ(each[0].where.channel, "acc2");
  d.ladder[0].alike = {{}};  // something else may be it
  EXPECT_TRUE(sensor_mass_findings(d, sheet).empty());
}

// Where the model lacks nothing, 100 g at a sensor would show: 3 g are a
// standard deviation.
TEST(SetUpMistakes, OfASensorWhoseMassIsNotThereAreNamed) {
  acquisition::TestBundle sheet;
  sheet.channels.resize(2);
  sheet.channels[1].name = "acc1";
  sheet.channels[1].mass_kg = 0.1;
  Candidate candidate;
  candidate.effect = "sensor-mass";
  candidate.where.channels = {"acc1"};
  candidate.parameters = {{"mass_kg", 1e-4, 0.003, 1e-4, 6.5, {}, true}};
  Diagnosis d;
  d.candidates = {candidate};
  d.verdict = "none";
  EXPECT_EQ(sensor_mass_findings(d, sheet).size(), 1U);
  sheet.channels[1].mass_kg = 0.008;
  EXPECT_TRUE(sensor_mass_findings(d, sheet).empty());
  sheet.channels[1].mass_kg = 0.1;
  d.verdict = "unexplained";
  EXPECT_TRUE(sensor_mass_findings(d, sheet).empty());
}

}  // namespace
}  // namespace tapfit::updating
