#include "acquisition/foundation/unit_slips.hpp"

#include "tests/support/matchers.hpp"

namespace tapfit::acquisition {
namespace {

// By the definitions of pound, inch and standard gravity.
TEST(UnitSlips, AreNamedByTheirFactorEitherWay) {
  EXPECT_THAT(channel_slip(9.80665), HasSubstr("9.807: g for m/s^2"));
  EXPECT_EQ(channel_slip(0.102), channel_slip(9.80665));
  EXPECT_THAT(channel_slip(1.0 / 4.4482216), HasSubstr("lbf for N"));
  EXPECT_THAT(channel_slip(39.37), HasSubstr("in for m"));
  EXPECT_THAT(channel_slip(3.16), HasSubstr("10 dB"));
  EXPECT_THAT(mass_slip(0.4536), HasSubstr("lb for kg"));
  EXPECT_THAT(mass_slip(1000.0), HasSubstr("g or t for kg"));
}

TEST(UnitSlips, OfNoUnitHaveNoName) {
  for (const double factor : {1.0, 0.8, 1.25, 2.0, 7.0, 60.0, 0.3}) {
    EXPECT_EQ(channel_slip(factor), "") << factor;
  }
  EXPECT_EQ(mass_slip(3.2), "");
}

TEST(UnitSlips, BetweenTwoFactorsStandNearestFirst) {
  EXPECT_THAT(
      units_between(200.0, 9600.0),
      AllOf(HasSubstr("1000: kN for N"), HasSubstr("; 386.1: g for in/s^2")));
  EXPECT_EQ(units_between(20.0, 30.0), "25.4: in for mm");
  EXPECT_EQ(units_between(1.0 / 30.0, 1.0 / 20.0), "25.4: in for mm");
  EXPECT_EQ(units_between(50.0, 90.0), "");
}

}  // namespace
}  // namespace tapfit::acquisition
