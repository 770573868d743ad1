// How a report names things and prints what was identified.
#include "tui/report/report_words.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(ReportWords, NameEffectsAndGroups) {
  EXPECT_EQ(effect_words("sensor-mass"), "mass of the sensors");
  EXPECT_EQ(effect_words("joint|stiffness-loss"),
            "joint that gives or loss of stiffness");
  EXPECT_EQ(effect_words("sensor-mass+soft-support"),
            "mass of the sensors and support that gives");
  EXPECT_EQ(effect_words("new-effect"), "new effect");
}

TEST(ReportWords, NamePlaces) {
  updating::Location where;
  EXPECT_EQ(place_words(where), "");
  where.nodes = {1, 2, 3, 4};
  where.variant = "rotation";
  EXPECT_EQ(found_words("soft-support", where),
            "support that gives (4 nodes, 1 … 4; rotation)");
}

// An axial force sits in members, not at the sensors that its rival sits at.
TEST(ReportWords, GiveThePlaceToTheLeadingKindOfAGroup) {
  EXPECT_EQ(
      found_words("sensor-cable|prestress", {.channels = {"acc1", "acc2"}}),
      effect_words("sensor-cable") + " (acc1, acc2) or " +
          effect_words("prestress"));
  EXPECT_EQ(found_words("joint|stiffness-loss", {}),
            effect_words("joint|stiffness-loss"));
}

TEST(Quantity, IsInTheUnitThatItsSizeAsksFor) {
  const Quantity mass =
      quantity({"mass_kg", 0.02004, 0.00016, 0.01972, 0.02036});
  EXPECT_EQ(mass.name, "mass");
  EXPECT_EQ(mass.value, "20.04 ± 0.16");
  EXPECT_EQ(mass.interval, "19.72 … 20.36");
  EXPECT_EQ(mass.unit, "g");
  const Quantity E = quantity({"E:1", 7.07e10, 2e8, 7.03e10, 7.11e10, "Pa"});
  EXPECT_EQ(E.value, "70.70 ± 0.20");
  EXPECT_EQ(E.unit, "GPa");
  const Quantity k = quantity(
      {"rotational_stiffness_nm_per_rad", 1648.0, 18.0, 1613.0, 1683.0});
  EXPECT_EQ(k.name, "rotational stiffness");
  EXPECT_EQ(k.unit, "N·m/rad");
}

TEST(Quantity, WritesAnInertiaInItsUnit) {
  const Quantity J = quantity({"inertia_kg_m2", 8.9e-7, 3.6e-7, 4e-7, 2e-6});
  EXPECT_EQ(J.name, "inertia");
  EXPECT_EQ(J.value, "0.89 ± 0.36");
  EXPECT_EQ(J.interval, "0.40 … 2.00");
  EXPECT_EQ(J.unit, "kg·mm²");
}

// 0.02 g with a deviation of 0.33 g.
TEST(Quantity, SaysWhereTheDataTellNothing) {
  const Quantity mass =
      quantity({"mass_kg", 0.00002, 0.00033, 1.502e-05, 0.7509});
  EXPECT_EQ(mass.value, "not determined");
  const Quantity density = quantity({"rho:1", 4000.0, 5000.0, 5624.0, 14120.0});
  EXPECT_EQ(density.interval, "5600 … 14100");
}

TEST(Quantity, IsSetInPowersOfTen) {
  const Quantity k =
      quantity({"stiffness_n_per_m", -7.07e10, 2e8, -7.11e10, -7.03e10});
  EXPECT_EQ(k.value, "(−7.070 ± 0.020)·10¹⁰");
  EXPECT_EQ(k.interval, "(−7.110 … −7.030)·10¹⁰");
  EXPECT_EQ(value_words({"stiffness_n_per_m", 1.0}, 2.5e-6), "2.5·10⁻⁶ N/m");
}

TEST(Quantity, NamesTheMeshesCorrections) {
  EXPECT_EQ(quantity({"mesh size", 1.2, 0.1, 1.0, 1.4}).name,
            "mesh correction (size)");
}

TEST(ContourWords, SayHowManyFrequenciesAndHowMuchDamping) {
  EXPECT_EQ(contour_words("136 lines from 1 to 55 Hz on s = sigma + j omega, "
                          "sigma = 0.03 omega and at least 0.188 1/s"),
            "evaluated at 136 frequencies, 1–55 Hz, with 3 % added damping");
  EXPECT_EQ(
      contour_words("83 lines from 61.1636 to 700 Hz on s = sigma + j "
                    "omega, sigma = 0.03 omega"),
      "evaluated at 83 frequencies, 61.16–700 Hz, with 3 % added damping");
  EXPECT_EQ(contour_words("s = 5 + jw"), "s = 5 + jw");
}

TEST(SignedPercentWords, HaveNoNegativeZero) {
  EXPECT_EQ(signed_percent_words(-0.001), "0.00 %");
  EXPECT_EQ(signed_percent_words(0.001), "0.00 %");
  EXPECT_EQ(signed_percent_words(1.914), "+1.91 %");
  EXPECT_EQ(signed_percent_words(-1.914), "−1.91 %");
}

TEST(Enumerated, EndsInAnd) {
  EXPECT_EQ(enumerated({}), "");
  EXPECT_EQ(enumerated({"a"}), "a");
  EXPECT_EQ(enumerated({"a", "b", "c"}), "a, b and c");
}

TEST(NextWords, SayWhereToHit) {
  updating::NextMeasurement next;
  next.one = {"added-mass", {.node = 5}};
  next.other = {"joint", {.node = 6}};
  next.hit = {144, 3, 1};
  next.sensor = {146, 3, 1};
  next.channel = "acc1";
  next.moves_sensor = true;
  next.difference = 0.031;
  next.difference_now = 0.014;
  EXPECT_EQ(
      next_words(next, 0.01),
      "To separate an added mass (node 5) from a joint that gives (node 6): "
      "hit 144Z+ with acc1 moved to 146Z+ (they differ by 3.1 % there, by "
      "1.4 % at your points).");
}

TEST(NextWords, NameBothFormsOfOneEffect) {
  updating::NextMeasurement next;
  next.one = {"sensor-mass", {.channels = {"acc1"}, .variant = "rotary"}};
  next.other = {"sensor-mass", {.channels = {"acc1"}}};
  next.difference = 0.031;
  EXPECT_TRUE(next_words(next, 0.01)
                  .starts_with("To separate the mass of the sensors (acc1; "
                               "with rotary inertia) from "
                               "the mass of the sensors (acc1): hit"))
      << next_words(next, 0.01);
}

TEST(Typeset, WritesSignsInOneCharacter) {
  EXPECT_EQ(typeset("1 +- 2 m/s^2 (1 ... 3)"), "1 ± 2 m/s² (1 … 3)");
  EXPECT_EQ(typeset("-1 of frame-2, `band_hz` 4-5"),
            "−1 of frame-2, band_hz 4-5");
}

}  // namespace
}  // namespace tapfit::tui
