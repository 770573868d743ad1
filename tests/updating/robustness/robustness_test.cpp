#include "updating/robustness/robustness.hpp"

#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/diagnosis/made_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <string_view>
#include <vector>

namespace tapfit::updating {
namespace {

EffectInstance hidden_mass(double kg) {
  Location where;
  where.node = 30;
  return {&effects::find("added-mass"), where, {kg}};
}

/// A plate with a mass that a diagnosis finds.
class PlateWithAMass : public testing::Test {
 protected:
  PlateExperiment test_{{hidden_mass(0.02)}, 0.01, 3};
  Diagnosis diagnosis_ = test_.diagnose_it();
};

TEST_F(PlateWithAMass, NothingChangedGivesTheDiagnosisAgain) {
  ASSERT_EQ(diagnosis_.verdict, "added-mass");
  const FirmnessCheck check(
      test_.fitter(), test_.options(), diagnosis_, Progress{});
  const Robustness same = check.under(SettingChange{}, Progress{});
  EXPECT_TRUE(same.verdict_stands);
  EXPECT_EQ(same.verdict, "added-mass");
  ASSERT_EQ(same.parameters.size(), 1U);
  EXPECT_EQ(same.parameters[0].name, "added-mass mass_kg");
  // Fits end within a few hundredths of a standard error of the best.
  EXPECT_LT(same.largest_move_sd, 0.1);
  const Estimate& told = diagnosis_.ladder[0].parameters[0];
  EXPECT_NEAR(same.parameters[0].value, told.value, 0.1 * told.sd);
}

TEST_F(PlateWithAMass, AClearEffectStandsUnderEveryChange) {
  const std::vector<Robustness> rows =
      robustness(test_.fitter(), test_.options(), diagnosis_, Progress{});
  // Two priors and the form up and down, the modulus held, six runs.
  ASSERT_EQ(rows.size(), 13U);
  for (const Robustness& row : rows) {
    EXPECT_TRUE(row.verdict_stands) << row.change << ": " << row.verdict;
    EXPECT_EQ(row.parameters.size(), 1U) << row.change;
  }
  // The modulus is 2 % off: held at the deck's value, the mass makes up for it,
  // by most of a deviation that knows that decks are off by as much.
  const auto held = std::ranges::find(
      rows, "E:1 held at the deck's value", &Robustness::change);
  ASSERT_NE(held, rows.end());
  EXPECT_GT(held->largest_move_sd, 0.5);
}

TEST_F(PlateWithAMass, AFitIsKeptAsItEnded) {
  const MadeFit& found = diagnosis_.rivals.found;
  ASSERT_EQ(found.effects.size(), 1U);
  const Fit again = where_it_ended(found, test_.fitter().problem().context);
  EXPECT_EQ(as_made(again).sizes, found.sizes);
  EXPECT_EQ(as_made(again).zeta, found.zeta);
  EXPECT_EQ(again.effects[0].where.node, 30);
  ASSERT_EQ(diagnosis_.rivals.instead.size(), 1U);
  EXPECT_GT(diagnosis_.rivals.instead[0].size(), 1U) << "no rival was kept";
}

// The lightest mass that is just found: whatever takes a little of the evidence
// away, as leaving a sixth of the runs out does, overturns the verdict.
TEST(Robustness, ABorderlineVerdictDoesNotStandUnderAll) {
  double none = 0.0;
  double found = 0.02;
  const auto test_of = [](double kg) {
    return PlateExperiment({hidden_mass(kg)}, 0.03, 5);
  };
  while (found - none > 1e-3 * found) {
    const double between = 0.5 * (none + found);
    const bool seen = test_of(between).diagnose_it().verdict != "none";
    (seen ? found : none) = between;
  }
  const PlateExperiment test = test_of(found);
  const Diagnosis diagnosis = test.diagnose_it();
  ASSERT_NE(diagnosis.verdict, "none");
  const std::vector<Robustness> rows =
      robustness(test.fitter(), test.options(), diagnosis, Progress{});
  EXPECT_GE(std::ranges::count(rows, false, &Robustness::verdict_stands), 1);
  for (const Robustness& row : rows) {
    EXPECT_EQ(row.verdict_stands, row.verdict == diagnosis.verdict)
        << row.change;
  }
}

TEST(Robustness, StopsWhereItIsAskedTo) {
  const PlateExperiment test({hidden_mass(0.02)}, 0.01, 3);
  const Diagnosis diagnosis = test.diagnose_it();
  std::stop_source stop;
  const Progress stopping{
      [&stop](std::string_view, double) { stop.request_stop(); },
      stop.get_token()};
  EXPECT_THROW(
      (void)robustness(test.fitter(), test.options(), diagnosis, stopping),
      Stopped);
}

}  // namespace
}  // namespace tapfit::updating
