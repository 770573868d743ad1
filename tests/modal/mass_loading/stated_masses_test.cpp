#include "modal/mass_loading/stated_masses.hpp"

#include "tests/support/matchers.hpp"

namespace tapfit::modal {
namespace {

acquisition::TestBundle sheet(double first_kg, double second_kg) {
  acquisition::TestBundle bundle;
  bundle.channels.resize(3);
  bundle.channels[1].name = "acc1";
  bundle.channels[2].name = "acc2";
  if (first_kg > 0.0) bundle.channels[1].mass_kg = first_kg;
  if (second_kg > 0.0) bundle.channels[2].mass_kg = second_kg;
  return bundle;
}

PoleShifts ten_grams_each() {
  PoleShifts shifts;
  shifts.cause = ShiftCause::SensorMass;
  shifts.masses = {{0.010, 0.001, 0.008, 0.012}};
  shifts.sensors = {{1}, {2}};
  return shifts;
}

TEST(StatedMasses, ThatAreContradictedAreNamed) {
  const auto found = stated_mass_findings(sheet(0.1, 0.01), ten_grams_each());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].where.channel, "acc1");
  EXPECT_THAT(found[0].what, HasSubstr("10 g (sd 1 g)"));
  EXPECT_THAT(found[0].what, HasSubstr("100 g in test.json"));
}

// Three deviations of 1 g and of a tenth of the sheet's.
TEST(StatedMasses, WithinThreeDeviationsAreNot) {
  EXPECT_TRUE(
      stated_mass_findings(sheet(0.0132, 0.008), ten_grams_each()).empty());
}

TEST(StatedMasses, AreNotComparedWhereNothingTells) {
  EXPECT_TRUE(stated_mass_findings(sheet(0.1, 0.1), {}).empty());
  EXPECT_TRUE(stated_mass_findings(sheet(0.0, 0.0), ten_grams_each()).empty());
  PoleShifts other = ten_grams_each();
  other.cause = ShiftCause::SameFraction;
  EXPECT_TRUE(stated_mass_findings(sheet(0.1, 0.1), other).empty());
  other = ten_grams_each();
  other.masses.clear();
  EXPECT_TRUE(stated_mass_findings(sheet(0.1, 0.1), other).empty());
}

// Three axes of 10 g each, or 3.3 g written at each of them.
TEST(StatedMasses, OfAxesOfOneSensorMayBeItsOwnOrTheirShare) {
  for (const double each : {0.010, 0.005}) {
    PoleShifts shifts = ten_grams_each();
    shifts.sensors = {{1, 2}};
    EXPECT_TRUE(stated_mass_findings(sheet(each, each), shifts).empty());
  }
}

}  // namespace
}  // namespace tapfit::modal
