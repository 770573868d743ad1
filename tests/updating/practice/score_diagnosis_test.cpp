#include "updating/practice/score_diagnosis.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

VirtualBundleSpec hiding(const std::string& name,
                         const std::string& place,
                         double value) {
  VirtualBundleSpec spec;
  spec.effects = {{name, {place}, {value}}};
  return spec;
}

Diagnosis finding(const std::string& name, int node, double value) {
  Rung rung;
  rung.added = name;
  rung.where.node = node;
  rung.parameters = {{"mass_kg", value, 0.001, value - 0.002, value + 0.002}};
  Diagnosis diagnosis;
  diagnosis.verdict = name;
  diagnosis.ladder = {rung};
  return diagnosis;
}

TEST(ScoreDiagnosis, TellsKindPlaceAndSize) {
  const structure::Deck deck = support::plate_deck(true);
  const VirtualBundleSpec hidden = hiding("added-mass", "30", 0.05);
  const DiagnosisScore right =
      score_diagnosis(hidden, finding("added-mass", 30, 0.051), deck);
  EXPECT_TRUE(right.right_kind);
  EXPECT_TRUE(right.right_place);
  EXPECT_NEAR(right.size_error, 0.02, 1e-12);
  EXPECT_EQ(right.intervals_hold, 1);
  // The next grid is one element away, grid 28 two.
  EXPECT_TRUE(score_diagnosis(hidden, finding("added-mass", 29, 0.05), deck)
                  .right_place);
  EXPECT_FALSE(score_diagnosis(hidden, finding("added-mass", 28, 0.05), deck)
                   .right_place);
  EXPECT_FALSE(
      score_diagnosis(hidden, finding("dashpot", 30, 0.05), deck).right_kind);
}

TEST(ScoreDiagnosis, OutsideTheCatalogueUnexplainedIsRight) {
  const structure::Deck deck = support::plate_deck(true);
  VirtualBundleSpec strut;
  strut.effects = {{"strut", {"30", "20"}, {1e4}}};
  EXPECT_FALSE(
      score_diagnosis(strut, finding("added-mass", 30, 0.05), deck).right_kind);
  Diagnosis honest;
  honest.verdict = "unexplained";
  EXPECT_TRUE(score_diagnosis(strut, honest, deck).right());
}

TEST(ScoreDiagnosis, NoneIsRightOnlyWhereNothingIsHidden) {
  const structure::Deck deck = support::plate_deck(true);
  Diagnosis none;
  none.verdict = "none";
  none.error_best = 0.02;
  none.floor = 0.019;
  EXPECT_TRUE(score_diagnosis({}, none, deck).right());
  none.error_best = 0.03;
  EXPECT_FALSE(score_diagnosis({}, none, deck).right()) << "above the floor";
  EXPECT_FALSE(
      score_diagnosis(hiding("added-mass", "30", 0.05), none, deck).honest);
  Diagnosis alarm;
  alarm.verdict = "unexplained";
  EXPECT_FALSE(score_diagnosis({}, alarm, deck).honest) << "nothing is missing";
}

TEST(ScoreDiagnosis, SizeIsRightWithinFivePercentOrItsInterval) {
  const structure::Deck deck = support::plate_deck(true);
  const VirtualBundleSpec hidden = hiding("added-mass", "30", 0.05);
  // finding() states +-0.002: 6 % off and outside, 4 % off, 6 % with a wide
  // interval.
  EXPECT_FALSE(score_diagnosis(hidden, finding("added-mass", 30, 0.053), deck)
                   .right_size);
  EXPECT_TRUE(score_diagnosis(hidden, finding("added-mass", 30, 0.052), deck)
                  .right_size);
  Diagnosis unsure = finding("added-mass", 30, 0.053);
  unsure.ladder[0].parameters[0].lo95 = 0.049;
  EXPECT_TRUE(score_diagnosis(hidden, unsure, deck).right_size);
}

TEST(ScoreDiagnosis, AGroupThatHoldsTheHiddenKindIsHonestNotRight) {
  const structure::Deck deck = support::plate_deck(true);
  const VirtualBundleSpec hidden = hiding("added-mass", "30", 0.05);
  const DiagnosisScore group = score_diagnosis(
      hidden, finding("sensor-mass|added-mass", 30, 0.05), deck);
  EXPECT_FALSE(group.right_kind);
  EXPECT_TRUE(group.honest);
  EXPECT_FALSE(
      score_diagnosis(hidden, finding("dashpot|joint", 30, 0.05), deck).honest);
  EXPECT_FALSE(
      score_diagnosis(hidden, finding("added-mass+dashpot", 30, 0.05), deck)
          .honest);
}

TEST(ScoreDiagnosis, WrongGridMustBeNamedAndNothingElse) {
  const structure::Deck deck = support::plate_deck(true);
  VirtualBundleSpec hidden;
  hidden.effects = {{"wrong-grid", {"30", "27"}, {}}};
  Diagnosis found;
  found.verdict = "none";
  found.error_best = found.floor = 0.01;
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_kind) << "not seen";
  found.verdict = "point-mislabelled";
  Rung rung;
  rung.added = found.verdict;
  rung.where.channels = {"hammer"};
  rung.where.nodes = {27};
  rung.where.node = 30;
  found.ladder = {rung};
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right());
  found.ladder[0].where.node = 28;
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right())
      << "two elements away";
  EXPECT_FALSE(score_diagnosis({}, found, deck).right()) << "nobody erred";
}

TEST(ScoreDiagnosis, SupportMustTurnEverywhere) {
  const structure::Deck deck = support::plate_deck(true);
  VirtualBundleSpec hidden;
  hidden.effects = {{"soft-support", {}, {100.0}}};
  Diagnosis found = finding("soft-support", 0, 100.0);
  Rung& rung = found.ladder[0];
  rung.parameters[0].name = "rotational_stiffness_nm_per_rad_per_m";
  rung.where.variant = "rotation";
  rung.where.nodes = {1, 12, 23, 34, 45};  // the clamped edge of plate_deck()
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right_place);
  rung.where.nodes = {1, 12};
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_place);
  rung.where.nodes = {1, 12, 23, 34, 45};
  rung.where.variant = "translation";
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_place);
}

TEST(ScoreDiagnosis, ASupportThatMovesTooHasBothSizes) {
  const structure::Deck deck = support::plate_deck(true);
  VirtualBundleSpec hidden;
  hidden.effects = {{"soft-support", {}, {100.0, 5e4}, "both"}};
  Diagnosis found = finding("soft-support", 0, 100.0);
  Rung& rung = found.ladder[0];
  rung.where.nodes = {1, 12, 23, 34, 45};
  const Estimate any = rung.parameters[0];
  const auto estimate = [&any](const std::string& name, double value) {
    Estimate e = any;
    e.name = name;
    e.value = e.lo95 = e.hi95 = value;
    return e;
  };
  // As effect_estimates() has them, totals last.
  rung.parameters = {estimate("rotational_stiffness_nm_per_rad_per_m", 101.0),
                     estimate("translational_stiffness_n_per_m_per_m", 5.1e4),
                     estimate("rotational_stiffness_nm_per_rad", 1.0),
                     estimate("translational_stiffness_n_per_m", 1.0)};
  rung.where.variant = "rotation";
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_place) << "moves too";
  rung.where.variant = "both";
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right_place);
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right_size);
  EXPECT_NEAR(score_diagnosis(hidden, found, deck).size_error, 0.02, 1e-12);
  rung.parameters[1].value = 6e4;
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_size);

  hidden.effects = {{"soft-support", {}, {5e4}, "translation"}};
  rung.where.variant = "translation";
  rung.parameters = {estimate("translational_stiffness_n_per_m_per_m", 5.1e4)};
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right_place);
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right_size);
  rung.where.variant = "rotation";
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_place)
      << "it does not turn";
}

TEST(ScoreDiagnosis, UnequalSensorsHaveASizeEach) {
  const structure::Deck deck = support::plate_deck(true);
  VirtualBundleSpec hidden;
  hidden.effects = {{"sensor-mass", {}, {0.01, 0.02}}};
  Diagnosis found = finding("sensor-mass", 0, 0.01);
  Rung& rung = found.ladder[0];
  rung.where.channels = {"acc1", "acc2"};
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_size)
      << "one for both";
  rung.where.variant = "each";
  rung.parameters = {{"mass_kg.acc1", 0.0102, 1e-4, 0.0098, 0.0104},
                     {"mass_kg.acc2", 0.0199, 1e-4, 0.0195, 0.0203}};
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right_size);
  EXPECT_EQ(score_diagnosis(hidden, found, deck).intervals_hold, 2);
  rung.parameters[1].value = 0.015;
  rung.parameters[1].hi95 = 0.016;
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_size);
}

TEST(ScoreDiagnosis, AnUnevenSupportHasTwoSizes) {
  const structure::Deck deck = support::plate_deck(true);
  VirtualBundleSpec hidden;
  hidden.effects = {{"soft-support", {}, {100.0, 10.0}}};
  Diagnosis found = finding("soft-support", 0, 100.0);
  Rung& rung = found.ladder[0];
  rung.where.nodes = {1, 12, 23, 34, 45};
  rung.where.variant = "rotation-varying";
  rung.parameters[0].name = "rotational_stiffness_nm_per_rad_per_m.1";
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_size) << "one alone";
  Estimate last = rung.parameters[0];
  last.name = "rotational_stiffness_nm_per_rad_per_m.45";
  last.value = last.lo95 = last.hi95 = 10.0;
  rung.parameters.push_back(last);
  EXPECT_TRUE(score_diagnosis(hidden, found, deck).right_size);
  rung.parameters[1].value = rung.parameters[1].hi95 = 20.0;
  rung.parameters[1].lo95 = 19.0;
  EXPECT_FALSE(score_diagnosis(hidden, found, deck).right_size)
      << "twice too stiff";
}

}  // namespace
}  // namespace tapfit::updating
