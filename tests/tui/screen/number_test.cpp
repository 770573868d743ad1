#include "tui/screen/number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tapfit::tui {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Number, FitsIntoFewCellsAndIsNeverCut) {
  EXPECT_EQ(fitted(9.5e-5, 4), "0.00");
  EXPECT_EQ(fitted(1.984, 4), "1.98");
  EXPECT_EQ(fitted(1.984, 3), "2.0");
  EXPECT_EQ(fitted(9.96, 3), "10");
  EXPECT_EQ(fitted(15.27, 4), "15.3");
  EXPECT_EQ(fitted(1234.0, 4), "1234");
  EXPECT_EQ(fitted(1234.0, 3), "1k");
  EXPECT_EQ(fitted(12345.0, 4), "12k");
  EXPECT_EQ(fitted(999999.0, 4), "1.0M");
  EXPECT_EQ(fitted(std::nan(""), 4), "–");
}

TEST(Number, NeverShowsWhatIsNoNumber) {
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    EXPECT_EQ(number(bad), "–");
    EXPECT_EQ(fixed(bad, 2), "–");
    EXPECT_EQ(percent(bad), "–");
    EXPECT_EQ(with_sd(bad, 1.0), "–");
  }
  EXPECT_EQ(with_sd(2.5, std::nan("")), "2.5");
}

TEST(Number, GivesTheDeviationTwoDigitsAndTheValueAsMany) {
  EXPECT_EQ(with_sd(2.271, 0.0004), "2.27100 ± 0.00040");
  EXPECT_EQ(with_sd(78.512, 1.5), "78.5 ± 1.5");
  EXPECT_EQ(with_sd(2.271, 0.0004, 1), "2.2710 ± 0.0004");
  EXPECT_EQ(with_sd(7.07e10, 2e8), "(7.070 ± 0.020)e10");
  EXPECT_EQ(with_sd(3.0, 0.0), "3");
  EXPECT_EQ(with_sd(7e10, 0.0), "7e10") << "as with a deviation";
  EXPECT_EQ(with_sd(-2.5e-6, 0.0), "-2.5e-6");
  EXPECT_EQ(with_sd(0.0, 0.0), "0");
}

TEST(Number, IsPlainUpToAMillion) {
  EXPECT_EQ(number(119102.0), "119100");
  EXPECT_EQ(number(-14120.0), "-14120");
  EXPECT_EQ(number(97370.0, 2), "97000");
  EXPECT_EQ(number(999960.0), "1e+06");
  EXPECT_EQ(number(1234.0), "1234");
  EXPECT_EQ(number(4.0e-5), "4e-05");
  EXPECT_EQ(with_sd(119102.0, 12244.0), "119000 ± 12000");
  EXPECT_EQ(with_sd(50.0, 0.996), "50.0 ± 1.0");
}

TEST(Number, RoundsAnIntervalAsItsValue) {
  const auto said = [](double value, double sd, double lo, double hi) {
    const Spread words = spread({"x", value, sd, lo, hi});
    return words.value + "; " + words.interval;
  };
  EXPECT_EQ(said(119102.0, 12244.0, 97370.0, 145700.0),
            "119000 ± 12000; 97000 … 146000");
  EXPECT_EQ(said(395.123, 0.52, 394.1, 396.0),
            "395.12 ± 0.52; 394.10 … 396.00");
  EXPECT_EQ(said(68.7, 0.5, 67.68, 69.7), "68.70 ± 0.50; 67.68 … 69.70");
  EXPECT_EQ(said(7.07e10, 2e8, 7.03e10, 7.11e10),
            "(7.070 ± 0.020)e10; (7.030 … 7.110)e10");
  EXPECT_EQ(said(9e5, 1e5, 7e5, 1.1e6), "(0.90 ± 0.10)e6; (0.70 … 1.10)e6");
  EXPECT_EQ(said(2.5, 0.0, 2.5, 2.5), "2.5; 2.5 … 2.5");
}

TEST(Number, StaysShortForHugeValues) {
  EXPECT_LE(fixed(1e300, 3).size(), 10U);
  EXPECT_EQ(fixed(-0.0001, 2), "0.00");
}

TEST(Number, SplitsUnitsOffNames) {
  EXPECT_EQ(split_unit("mass_kg").unit, "kg");
  EXPECT_EQ(split_unit("mass_kg.acc1").name, "mass.acc1");
  EXPECT_EQ(split_unit("rotational_stiffness_nm_per_rad").unit, "N m/rad");
  EXPECT_EQ(split_unit("damping_ns_per_m").name, "damping");
  EXPECT_EQ(split_unit("inertia_kg_m2").name, "inertia");
  EXPECT_EQ(split_unit("inertia_kg_m2").unit, "kg m^2");
  EXPECT_EQ(split_unit("force_n").unit, "N");
  EXPECT_EQ(split_unit("E:1").unit, "Pa");
  EXPECT_EQ(split_unit("factor").unit, "");
}

TEST(Number, WritesPercentWithSenseBelowOne) {
  EXPECT_EQ(percent(0.388), "38.8 %");
  EXPECT_EQ(percent(0.0042), "0.42 %");
}

TEST(Number, TellsSmallProbabilitiesFromNone) {
  EXPECT_EQ(probability(0.983), "98.3 %");
  EXPECT_EQ(probability(0.0006), "0.1 %");
  EXPECT_EQ(probability(0.0004), "<0.1 %");
}

TEST(Number, TellsATotalFromItsValuePerMetre) {
  EXPECT_EQ(split_unit("rotational_stiffness_nm_per_rad").name,
            "rotational stiffness");
  EXPECT_EQ(split_unit("rotational_stiffness_nm_per_rad_per_m").name,
            "rotational stiffness per m");
}

// One grid shares nothing out: its stiffness is no stiffness per metre.
TEST(Number, TellsNothingPerMetreOfOneGrid) {
  const updating::Estimate total{"rotational_stiffness_nm_per_rad", 523.0, 8.0};
  updating::Estimate per_m{"rotational_stiffness_nm_per_rad_per_m", 523.0, 8.0};
  ASSERT_EQ(told({total, per_m}).size(), 1U);
  EXPECT_EQ(told({total, per_m})[0].name, total.name);
  EXPECT_EQ(told_name(per_m.name, {total, per_m}), total.name);
  EXPECT_EQ(told({per_m}).size(), 1U);
  per_m.value = 3269.0;  // over 16 cm
  EXPECT_EQ(told({total, per_m}).size(), 2U);
  EXPECT_EQ(told_name(per_m.name, {total, per_m}), per_m.name);
}

TEST(Number, PutsThePlacesVariantFirst) {
  updating::Location where;
  where.nodes = {1, 3, 4, 38};
  where.variant = "rotation";
  EXPECT_EQ(place(where), "rotation, 4 nodes (1 ... 38)");
  where.variant = "both";
  EXPECT_EQ(place(where), "rotation and translation, 4 nodes (1 ... 38)");
}

// "0.00002 ± 0.00033 kg" would say nothing of a mass up to 0.75 kg.
TEST(Number, GivesTheEndOfAnIntervalThatHoldsNothing) {
  EXPECT_EQ(describe({"mass_kg", 2e-5, 3.3e-4, 1.502e-5, 0.7509}),
            "mass at most 0.75 kg");
  EXPECT_EQ(describe({"delay_s", 1e-5, 3e-5, -5e-5, 7e-5}),
            "delay -5e-05 to 7e-05 s");
  EXPECT_EQ(describe({"mass_kg", 0.08, 0.001, 0.078, 0.082}),
            "mass 0.0800 ± 0.0010 kg");
}

TEST(Number, SaysWhichBoundAFitEndedAt) {
  updating::Estimate low{"factor", 0.05, 0.01, 0.05, 0.081};
  low.at_bound = true;
  EXPECT_EQ(describe(low), "factor at most 0.081");
  updating::Estimate high{"factor", 0.95, 0.01, 0.92, 0.95};
  high.at_bound = true;
  EXPECT_EQ(describe(high), "factor at least 0.92");
}

// "at most 1" is said of every factor, "at most -2800 N" of the larger ones.
TEST(Number, GivesBothEndsWhereOneSaysNothing) {
  updating::Estimate factor{"factor", 0.04, 0.48, 0.04, 1.0};
  factor.at_bound = true;
  EXPECT_EQ(describe(factor), "factor 0.04 to 1");
  updating::Estimate force{"force_n", -25080.0, 12535.0, -49000.0, -2800.0};
  force.at_bound = true;
  EXPECT_EQ(describe(force), "force -49000 to -2800 N");
  updating::Estimate stuck{"factor", 0.31623, 0.0, 0.31623, 0.31623};
  stuck.at_bound = true;
  EXPECT_EQ(describe(stuck), "factor 0.316, at its bound");
}

TEST(Number, NamesParametersByTheirCards) {
  EXPECT_EQ(parameter_words("E:1"), "E (MAT1 1)");
  EXPECT_EQ(parameter_words("G12:3"), "G12 (MAT8 3)");
  EXPECT_EQ(parameter_words("I1:7"), "I1 (property 7)");
  EXPECT_EQ(parameter_words("mesh size"), "mesh correction (size)");
  EXPECT_EQ(parameter_words("added-mass mass_kg"), "added-mass mass");
}

}  // namespace
}  // namespace tapfit::tui
