#include "updating/diagnosis/classify_diagnosis.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

/// FRFs that surely change with the force, by so much.
signal::LinearityFinding changing(double change) {
  signal::LinearityFinding level;
  level.p_value = 0.0002;
  level.change = change;
  return level;
}

Diagnosis errors(double base, double best, double floor) {
  Diagnosis diagnosis;
  diagnosis.error_base = base;
  diagnosis.error_best = best;
  diagnosis.floor = floor;
  return diagnosis;
}

Diagnosis with_mass(double best) {
  Diagnosis diagnosis = errors(0.5, best, 0.02);
  diagnosis.error_fitted = 0.4;
  diagnosis.ladder.push_back({"added-mass", {}, best, {}});
  Candidate mass;
  mass.effect = "added-mass";
  diagnosis.candidates = {mass, mass};
  return diagnosis;
}

std::string verdict(Diagnosis diagnosis,
                    const signal::LinearityFinding& level) {
  classify_diagnosis(level, {}, diagnosis);
  return diagnosis.verdict;
}

TEST(SetVerdict, NamesTheLadderNoneOrUnexplained) {
  EXPECT_EQ(verdict(with_mass(0.03), {}), "added-mass");
  EXPECT_EQ(verdict(errors(0.05, 0.05, 0.02), {}), "none");
  EXPECT_EQ(verdict(errors(0.5, 0.5, 0.02), {}), "unexplained");
  Diagnosis far = with_mass(0.3);
  classify_diagnosis({}, {}, far);
  EXPECT_EQ(far.verdict, "unexplained");
  EXPECT_EQ(far.warnings.size(), 1U);
}

TEST(SetVerdict, NamesWhatHoldsTheFitBeforeAnythingIsMissing) {
  const std::vector<std::string> held = {"E:1 ended at its upper bound, 9"};
  for (Diagnosis diagnosis : {with_mass(0.3), errors(0.5, 0.5, 0.02)}) {
    classify_diagnosis({}, held, diagnosis);
    EXPECT_EQ(diagnosis.verdict, "unexplained");
    ASSERT_EQ(diagnosis.warnings.size(), 1U);
    EXPECT_NE(diagnosis.warnings[0].find(
                  "0.02: E:1 ended at its upper bound, 9; or something else"),
              std::string::npos)
        << diagnosis.warnings[0];
  }
  Diagnosis good = with_mass(0.03);
  classify_diagnosis({}, held, good);
  EXPECT_TRUE(good.warnings.empty());
}

TEST(SetVerdict, SaysWhereNonlinearityCouldNotBeLookedFor) {
  Diagnosis scattered = errors(0.4, 0.4, 0.3);
  classify_diagnosis({}, {}, scattered);
  ASSERT_EQ(scattered.warnings.size(), 1U);
  EXPECT_NE(scattered.warnings[0].find("three hits"), std::string::npos);
  signal::LinearityFinding seen;
  seen.runs = 8;
  Diagnosis looked = errors(0.4, 0.4, 0.3);
  classify_diagnosis(seen, {}, looked);
  EXPECT_TRUE(looked.warnings.empty());
}

// A base whose scale is off by a thousand leaves no excuse for an error of 1.
TEST(SetVerdict, AWrongScaleExplainsNothing) {
  Diagnosis diagnosis = with_mass(1.1);
  diagnosis.error_base = 900.0;
  EXPECT_EQ(verdict(diagnosis, {}), "unexplained");
}

TEST(SetVerdict, NonlinearityIsWhatNoLinearModelCanReach) {
  EXPECT_EQ(verdict(errors(0.05, 0.05, 0.02), changing(0.08)), "nonlinearity");
  EXPECT_EQ(verdict(errors(0.5, 0.5, 0.02), changing(0.3)), "nonlinearity");
  EXPECT_EQ(verdict(with_mass(0.03), changing(0.05)),
            "added-mass+nonlinearity");
}

TEST(SetVerdict, SmallOrDoubtfulChangesAreNoVerdict) {
  // At a floor that the mesh makes.
  EXPECT_EQ(verdict(errors(0.04, 0.04, 0.04), changing(0.015)), "none");
  // At one that the change itself makes.
  EXPECT_EQ(verdict(errors(0.5, 0.5, 0.6), changing(0.36)), "nonlinearity");
  EXPECT_EQ(verdict(errors(0.5, 0.5, 0.02), changing(0.1)), "unexplained");
  signal::LinearityFinding doubtful = changing(0.08);
  doubtful.p_value = 0.002;
  EXPECT_EQ(verdict(errors(0.05, 0.05, 0.02), doubtful), "none");
}

TEST(SetVerdict, ALinearStandInTellsThePlaceOnly) {
  Diagnosis diagnosis = errors(0.4, 0.25, 0.1);
  diagnosis.error_fitted = 0.4;
  Rung spring{"ground-spring", {}, 0.25, {}};
  spring.where.node = 17;
  diagnosis.ladder = {spring};
  diagnosis.candidates.resize(1);
  classify_diagnosis(changing(0.2), {}, diagnosis);
  EXPECT_EQ(diagnosis.verdict, "nonlinearity");
  ASSERT_EQ(diagnosis.candidates.size(), 2U);
  EXPECT_EQ(diagnosis.candidates[0].effect, nonlinearity);
  EXPECT_EQ(diagnosis.candidates[0].where.node, 17);
  EXPECT_DOUBLE_EQ(diagnosis.candidates[0].probability, 1.0 - 0.0002);
  EXPECT_EQ(diagnosis.candidates[0].error, 0.25);
  ASSERT_EQ(diagnosis.warnings.size(), 1U);
  EXPECT_NE(diagnosis.warnings[0].find("ground-spring at node 17"),
            std::string::npos);
  // Grids that are not told apart are no place.
  Location next;
  next.node = 18;
  diagnosis.ladder[0].alike = {{"ground-spring", next}};
  classify_diagnosis(changing(0.2), {}, diagnosis);
  EXPECT_EQ(diagnosis.candidates[0].where.node, 0);
}

}  // namespace
}  // namespace tapfit::updating
