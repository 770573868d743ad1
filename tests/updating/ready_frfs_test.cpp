#include "updating/ready_frfs.hpp"

#include "signal/uff58.hpp"
#include "tests/acquisition/temporary_folder.hpp"
#include "tests/modal/loaded_system.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Eigen::Index;

constexpr Index kPoints = 6;

/// Four modes in the band and one above, hit at point 1.
test::SyntheticSystem test_system() {
  std::mt19937_64 random(3);
  test::SyntheticSystem system;
  system.frequency_hz.resize(5);
  system.frequency_hz << 15.0, 34.0, 58.0, 81.0, 130.0;
  system.damping_ratio = Eigen::VectorXd::Constant(5, 0.005);
  system.phi = test::random_shapes(kPoints, 5, random);
  system.phi.row(0).setOnes();
  return system;
}

/// A file of the FRFs from point 1 to all, a sensor of so many kg at the
/// response point of each and nowhere else.
acquisition::TestBundle with_sensor(double kg,
                                    const std::filesystem::path& folder) {
  const test::SyntheticSystem system = test_system();
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  signal::FrfSet set;
  set.s = test::line_points(5, 100, 800, 0.0);
  for (Index point = 0; point < kPoints; ++point) {
    signal::Frf frf;
    frf.response = {static_cast<int>(point) + 1, 3, 1};
    frf.reference = {1, 3, 1};
    frf.H.resize(set.lines());
    for (Index k = 0; k < set.lines(); ++k) {
      frf.H(k) =
          (1.0 + 0.003 * normal(random)) *
          test::loaded_accelerance(system, {point}, kg, point, 0, set.s(k));
    }
    set.frfs.push_back(frf);
  }
  acquisition::TestBundle bundle;
  bundle.frfs = folder / "frfs.uff";
  signal::write_frfs_uff(set, "six points", *bundle.frfs);
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
  ASSERT_EQ(bundle.runs.size(), static_cast<std::size_t>(kPoints));
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
  EXPECT_EQ(bundle.channels.size(), static_cast<std::size_t>(kPoints) + 1);
  ASSERT_EQ(ready.set.statements.size(), 1U);
  EXPECT_NE(ready.set.statements[0].find("stayed"), std::string::npos);
}

}  // namespace
}  // namespace tapfit::updating
