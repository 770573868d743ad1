#include "updating/measurement/ready_frfs.hpp"

#include "signal/files/uff58.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/modal/support/loaded_system.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

constexpr std::size_t points = 6;

/// A file of FRFs from one point to all.
acquisition::TestBundle with_sensor(double kg,
                                    const std::filesystem::path& folder) {
  acquisition::TestBundle bundle;
  bundle.frfs = folder / "frfs.uff";
  signal::write_frfs_uff(test::one_reference(kg, 0.003),
                         "six points",
                         *bundle.frfs,
                         {{}, true});
  return bundle;
}

TEST(SensorsOfReadyFrfs, ASensorThatMovedIsSeenByItsMass) {
  const testing::TemporaryFolder folder;
  constexpr double sensor = 0.004;
  acquisition::TestBundle bundle = with_sensor(sensor, folder.path());
  const ReadyFrfs ready = read_ready_frfs(bundle, {});
  ASSERT_TRUE(ready.modes.has_value());
  EXPECT_EQ(ready.modes->modes.size(), 4U);
  ASSERT_TRUE(ready.modes->shifts.has_value());
  ASSERT_EQ(ready.modes->shifts->masses.size(), 1U);
  // Shifts of up to 2 %, to which the second order adds 1 % of themselves.
  EXPECT_NEAR(ready.modes->shifts->masses[0].kg, sensor, 0.05 * sensor);
  ASSERT_EQ(bundle.channels.size(), 2U);
  EXPECT_EQ(bundle.channels[1].name, "sensor Z");
  ASSERT_EQ(bundle.runs.size(), points);
  EXPECT_EQ(bundle.runs[4].sensors[0].dof, (Dof{5, 3, 1}));
  ASSERT_EQ(ready.set.statements.size(), 1U);
  EXPECT_NE(ready.set.statements[0].find("moved"), std::string::npos);
}

TEST(SensorsOfReadyFrfs, WithoutLoadingAllSensorsStayed) {
  const testing::TemporaryFolder folder;
  acquisition::TestBundle bundle = with_sensor(0.0, folder.path());
  const ReadyFrfs ready = read_ready_frfs(bundle, {});
  ASSERT_TRUE(ready.modes.has_value());
  EXPECT_EQ(ready.modes->modes.size(), 4U);
  EXPECT_TRUE(ready.modes->set_ups.empty());
  EXPECT_EQ(bundle.runs.size(), 1U);
  EXPECT_EQ(bundle.channels.size(), points + 1);
  ASSERT_EQ(ready.set.statements.size(), 1U);
  EXPECT_NE(ready.set.statements[0].find("stayed"), std::string::npos);
}

TEST(SensorsOfReadyFrfs, TheirModesAreThoseOfTheBand) {
  const testing::TemporaryFolder folder;
  acquisition::TestBundle bundle = with_sensor(0.0, folder.path());
  const ReadyFrfs all = read_ready_frfs(bundle, {});
  ASSERT_TRUE(all.modes.has_value());
  ASSERT_EQ(all.modes->modes.size(), 4U);
  const auto hz = [&all](std::size_t k) {
    return all.modes->modes[k].frequency_hz;
  };
  bundle = with_sensor(0.0, folder.path());
  bundle.band_hz = {0.5 * (hz(0) + hz(1)), 0.5 * (hz(2) + hz(3))};
  const ReadyFrfs some = read_ready_frfs(bundle, {});
  ASSERT_TRUE(some.modes.has_value());
  ASSERT_EQ(some.modes->modes.size(), 2U);
  EXPECT_NEAR(some.modes->modes[0].frequency_hz, hz(1), 1e-4 * hz(1));
  EXPECT_NEAR(some.modes->modes[1].frequency_hz, hz(2), 1e-4 * hz(2));
}

}  // namespace
}  // namespace tapfit::updating
