// Elastic moduli of a free plate from a hammer test of one point: hit at one
// corner, felt at another.
#include "tests/updating/support/free_plate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using support::identify_plate;

TEST(PlateStiffness, ModulusOfAnIsotropicPlateIsWithinOnePercent) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const auto found = identify_plate({"MAT1,1,6.9+10,,.33,2700.\n",
                                       "MAT1,1,7.6+10,,.33,2700.\n",
                                       {"E"},
                                       seed});
    EXPECT_NEAR(found.at("E:1").value, 6.9e10, 0.01 * 6.9e10) << seed;
  }
}

// Two more such tests follow, whose mass is unknown besides.
TEST(PlateStiffness, ModuliOfASprucePlateAreWithinTwoPercent) {
  const auto found =
      identify_plate({"MAT8,1,1.2+10,.8+9,.4,.75+9,.75+9,.1+9,417.\n",
                      "MAT8,1,1.1+10,.9+9,.4,.7+9,.75+9,.1+9,417.\n",
                      {"E1", "E2", "G12"},
                      1});
  for (const auto& [name, truth] : {std::pair{"E1:1", 1.2e10},
                                    std::pair{"E2:1", 0.8e9},
                                    std::pair{"G12:1", 0.75e9}}) {
    const Estimate& e = found.at(name);
    EXPECT_NEAR(e.value, truth, 0.02 * truth) << name;
    // Standard errors that are no ornament: neither beyond four of them, nor
    // so wide that they say nothing.
    EXPECT_LT(std::abs(e.value - truth), 4.0 * e.sd) << name;
    EXPECT_LT(e.sd, 0.02 * truth) << name;
  }
}

// Frequencies tell the moduli over the mass; the scale of the FRFs alone tells
// the mass.
TEST(PlateStiffness, ModuliComeOutWithTheMassUnknownToo) {
  for (const double sensor_kg : {0.0, 0.004}) {
    const auto found =
        identify_plate({"MAT8,1,1.2+10,.8+9,.4,.75+9,.75+9,.1+9,417.\n",
                        "MAT8,1,1.1+10,.9+9,.4,.7+9,.75+9,.1+9,400.\n",
                        {"E1", "E2", "G12", "rho"},
                        3,
                        sensor_kg});
    for (const auto& [name, truth] : {std::pair{"E1:1", 1.2e10},
                                      std::pair{"E2:1", 0.8e9},
                                      std::pair{"G12:1", 0.75e9},
                                      std::pair{"rho:1", 417.0}}) {
      const Estimate& e = found.at(name);
      EXPECT_NEAR(e.value, truth, 0.02 * truth) << name << ' ' << sensor_kg;
      // Eight values are looked at: one in forty tests would go beyond three.
      EXPECT_LT(std::abs(e.value - truth), 3.0 * e.sd) << name << sensor_kg;
    }
    if (sensor_kg == 0.0) continue;
    const Estimate& mass = found.at("sensor-mass mass_kg");
    EXPECT_NEAR(mass.value, sensor_kg, 0.05 * sensor_kg);
  }
}

}  // namespace
}  // namespace tapfit::updating
