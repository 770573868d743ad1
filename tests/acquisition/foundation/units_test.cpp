#include "acquisition/foundation/units.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

// Factors are exact by definition (CGPM 1901, international yard and pound).
TEST(Units, KnowsFactors) {
  EXPECT_DOUBLE_EQ(find_unit("lbf")->si, 4.4482216152605);
  EXPECT_DOUBLE_EQ(find_unit("g")->si, 9.80665);
  EXPECT_DOUBLE_EQ(find_unit("in/s^2")->si, 0.0254);
  EXPECT_DOUBLE_EQ(find_unit("cm/s^2")->si, 0.01);
  EXPECT_EQ(find_unit("kN")->quantity, Quantity::Force);
  EXPECT_EQ(find_unit("mm")->quantity, Quantity::Displacement);
}

TEST(Units, AcceptsSpellings) {
  for (const char* text :
       {"m/s^2", "m/s2", "m/s²", "m/s**2", "(m/s^2)", "m / s^2", "m/s/s"}) {
    ASSERT_TRUE(find_unit(text)) << text;
    EXPECT_EQ(find_unit(text)->quantity, Quantity::Acceleration) << text;
    EXPECT_EQ(find_unit(text)->si, 1.0) << text;
  }
  EXPECT_EQ(find_unit("cm/s2")->si, 0.01);
  EXPECT_FALSE(find_unit("furlong"));
  EXPECT_FALSE(find_unit(""));
}

// As other programs write them; factors as above.
TEST(Units, KnowsOtherProgramsSpellings) {
  for (const char* text : {"G", "g's", "G's", "g", "(g)", "[g]"}) {
    ASSERT_TRUE(find_unit(text)) << text;
    EXPECT_EQ(find_unit(text)->quantity, Quantity::Acceleration) << text;
    EXPECT_EQ(find_unit(text)->si, 9.80665) << text;
  }
  for (const char* text : {"pound", "pounds", "lb", "lbs", "LBF"}) {
    ASSERT_TRUE(find_unit(text)) << text;
    EXPECT_EQ(find_unit(text)->quantity, Quantity::Force) << text;
    EXPECT_EQ(find_unit(text)->si, 4.4482216152605) << text;
  }
  for (const char* text : {"m/sec^2", "m/sec2", "m/sec/sec", "[m/s^2]"}) {
    ASSERT_TRUE(find_unit(text)) << text;
    EXPECT_EQ(find_unit(text)->si, 1.0) << text;
  }
  EXPECT_EQ(find_unit("Newtons")->si, 1.0);
  EXPECT_EQ(find_unit("gal")->si, 0.01);
  EXPECT_EQ(find_unit("inch/sec^2")->si, 0.0254);
  EXPECT_EQ(find_unit("cm")->si, 0.01);
  for (const char* text : {"mV", "V", "g rms", "m/s^2/V", "Pa", "sec"}) {
    EXPECT_FALSE(find_unit(text)) << text;
  }
}

TEST(Units, ReadsSensitivities) {
  EXPECT_EQ(find_sensitivity_unit("mV/g")->volts, 1e-3);
  EXPECT_DOUBLE_EQ(find_sensitivity_unit("mV/g")->unit.si, 9.80665);
  EXPECT_EQ(find_sensitivity_unit("V/(m/s^2)")->unit.si, 1.0);
  EXPECT_EQ(find_sensitivity_unit("V/m/s²")->unit.si, 1.0);
  EXPECT_FALSE(find_sensitivity_unit("pC/N"));
  EXPECT_FALSE(find_sensitivity_unit("V"));
}

}  // namespace
}  // namespace tapfit::acquisition
