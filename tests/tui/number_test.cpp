#include "tui/number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tapfit::tui {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

TEST(Number, PutsThePlacesVariantFirst) {
  updating::Where where;
  where.nodes = {1, 3, 38};
  where.variant = "rotation";
  EXPECT_EQ(place(where), "rotation, 3 nodes (1 ... 38)");
}

}  // namespace
}  // namespace tapfit::tui
