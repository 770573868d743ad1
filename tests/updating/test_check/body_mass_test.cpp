// Which of scale and deck is right, by tests that were made of a known mass.
#include "updating/test_check/body_mass.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/generated_bundle.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

/// Said of a sheet and a deck, each so many times the true mass.
BodyMass judged(testing::Structure structure, double scale, double deck) {
  static acquisition::TestBundle bundle;
  testing::PlainOptions options;
  options.seed = 3;
  options.structure = structure;
  const testing::SheetAndRecords test = testing::plain_test(options);
  const tapfit::testing::TemporaryFolder folder;
  testing::write_bundle(test, folder.path() / "test");
  Session session(folder.path() / "test");
  const double kg = test.bundle.weighed.value().mass_kg;
  bundle = test.bundle;
  bundle.weighed->mass_kg = scale * kg;
  BodyMass mass(bundle, {}, deck * kg);
  const signal::FrfSet& set = session.frfs({});
  mass.compare_with(set, session.modes({}), signal::driving_points(set));
  return mass;
}

bool says(const std::vector<Finding>& found, const char* words) {
  return found.size() == 1 &&
         in_full(found.front()).find(words) != std::string::npos;
}

TEST(BodyMass, IsThatWhichTheStructureMovesLike) {
  using enum testing::Structure;
  for (const testing::Structure structure : {FreePlate, ClampedBeam}) {
    const BodyMass fair = judged(structure, 1.0, 1.0);
    EXPECT_TRUE(fair.findings().empty());
    const double kg = fair.kg();
    const BodyMass scale = judged(structure, 1000.0, 1.0);
    EXPECT_TRUE(says(scale.findings(), "\"weighed\" in test.json is wrong"));
    EXPECT_EQ(scale.findings().front().severity, Severity::Error);
    // Without the sensors, which the deck lacks.
    EXPECT_NEAR(scale.kg() / kg, 1.0, 0.1);
    const BodyMass deck = judged(structure, 1.0, 1000.0);
    EXPECT_TRUE(
        says(deck.findings(), "density of the deck is in another unit"));
    EXPECT_NEAR(deck.kg() / kg, 1.0, 1e-9);
  }
}

// What no resonance can tell is left open.
TEST(BodyMass, IsTheScalesWhereBothMayBe) {
  const BodyMass mass = judged(testing::Structure::ClampedBeam, 1.0, 0.8);
  EXPECT_TRUE(says(mass.findings(), "parts or masses are missing"));
  EXPECT_EQ(mass.findings().front().severity, Severity::Warning);
  EXPECT_EQ(mass.tolerance(), 0.02);
}

TEST(BodyMass, IsMoreThanASensors) {
  acquisition::TestBundle bundle;
  acquisition::Channel heavy;
  heavy.name = "acc1";
  heavy.mass_kg = 20.0;
  acquisition::Channel light;
  light.mass_kg = 0.02;
  bundle.channels = {heavy, light};
  EXPECT_TRUE(says(BodyMass(bundle, {}, 0.24).findings(), "1000: g for kg"));
  EXPECT_TRUE(BodyMass(bundle, {}, 0.0).findings().empty());
}

}  // namespace
}  // namespace tapfit::updating
