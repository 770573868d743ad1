#include "updating/virtual_test/virtual_effect.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::updating {
namespace {

TEST(VirtualEffect, ReadsWhatIsWritten) {
  const VirtualEffect effect = parse_virtual_effect("absorber@44=0.05,31");
  EXPECT_EQ(effect.name, "absorber");
  EXPECT_EQ(effect.numbers(), std::vector<int>{44});
  EXPECT_EQ(effect.values, (std::vector<double>{0.05, 31.0}));
  EXPECT_EQ(parse_virtual_effect("stiffness-loss@1:2:7=0.5").numbers(),
            (std::vector<int>{1, 2, 7}));
  EXPECT_TRUE(parse_virtual_effect("channel-polarity@acc2").values.empty());
  for (const char* bad : {"magic=1",
                          "added-mass=1",
                          "added-mass@x=1",
                          "added-mass@1",
                          "added-mass@1=heavy",
                          "added-mass@1=1,2",
                          "soft-support@3=10",
                          "soft-support@both=10",
                          "soft-support@sideways=10",
                          "soft-support@both:both=10,10",
                          "sensor-mass=1,2,3",
                          "sensor-mass@acc1=1,2",
                          "strut@5:6:7=100",
                          "sensor-mass=nan",
                          ""}) {
    EXPECT_THROW((void)parse_virtual_effect(bad), InputError) << bad;
  }
}

TEST(VirtualEffect, ASupportsFormIsNoPlace) {
  EXPECT_EQ(parse_virtual_effect("soft-support@rotation=10").form, "");
  const VirtualEffect both = parse_virtual_effect("soft-support@both=10,1e5");
  EXPECT_EQ(both.form, "both");
  EXPECT_TRUE(both.places.empty());
  const nlohmann::ordered_json truth = truth_entry(both, {});
  EXPECT_EQ(truth["rotational_stiffness_per_m"], 10.0);
  EXPECT_EQ(truth["translational_stiffness_per_m"], 1e5);
  const std::string help = virtual_effect_help();
  EXPECT_NE(help.find("soft-support@translation=translational_stiffness_per_m"
                      "[,translational_stiffness_per_m_last]"),
            std::string::npos)
      << help;
}

TEST(VirtualEffect, MassesOfSensorsAreToldByChannel) {
  const nlohmann::ordered_json truth = truth_entry(
      parse_virtual_effect("sensor-mass=0.01,0.02"), {"acc1", "acc2"});
  EXPECT_EQ(truth["mass_kg.acc1"], 0.01);
  EXPECT_EQ(truth["mass_kg.acc2"], 0.02);
  EXPECT_FALSE(truth.contains("mass_kg"));
}

// What is with itself is nowhere else: it would hide nothing.
TEST(VirtualEffect, NothingIsSwappedOrJoinedWithItself) {
  for (const char* bad : {"channel-swap@acc1:acc1",
                          "strut@5:5=100",
                          "wrong-grid@5:5",
                          "stiffness-loss@7:7=0.5",
                          "sensor-mass@acc1:acc1=0.01,0.02"}) {
    try {
      (void)parse_virtual_effect(bad);
      ADD_FAILURE() << bad;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("the same place twice"),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
