#include "updating/set_up/sheet_edits.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/mistakes.hpp"

#include <gtest/gtest.h>

namespace tapfit::effects {
namespace {

using Edits = std::vector<std::string>;

// With nothing put right before.
Edits edits(const Effect& effect,
            const Location& where,
            const acquisition::TestBundle& written) {
  return sheet_edits(effect, where, written, written);
}

TEST(SheetEdits, NameRunPlaceAndGrids) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  // Grid 28 is hit in the fourth run.
  const Location where{.node = 30, .nodes = {28}, .channels = {"hammer"}};
  EXPECT_EQ(edits(point_mislabelled(), where, bundle),
            Edits{"runs[3].hammer.node: 28 -> 30"});
}

TEST(SheetEdits, AreOneForRunsAlike) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  const Location where{
      .node = 33, .nodes = {36}, .channels = {"acc2"}, .runs = {1, 4, 5, 6}};
  EXPECT_EQ(edits(point_mislabelled(), where, bundle),
            Edits{"runs[0,3-5].sensors[1].node: 36 -> 33"});
}

TEST(SheetEdits, OfASwapAreGridAndDirectionOfBoth) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  const Location where{.channels = {"acc1", "acc2"}};
  EXPECT_EQ(edits(channel_swap(), where, bundle),
            (Edits{"runs[0-5].sensors[0].direction: +Z -> -Z",
                   "runs[0-5].sensors[0].node: 11 -> 36",
                   "runs[0-5].sensors[1].direction: -Z -> +Z",
                   "runs[0-5].sensors[1].node: 36 -> 11"}));
}

// 100 mV/g, kept as V per m/s^2 or per g: the file may have it in any unit.
TEST(SheetEdits, OfASensitivityCountInWhateverUnitTheFileHas) {
  acquisition::TestBundle bundle = support::plate_bundle();
  bundle.channels[1].sensitivity = 0.1 / 9.80665;
  Location where{.channels = {"acc1"}};
  EXPECT_EQ(edits(channel_polarity(), where, bundle),
            Edits{"channels[1].sensitivity: other sign"});
  where.variant = "9.807";
  EXPECT_EQ(edits(unit_factor(), where, bundle),
            Edits{"channels[1].sensitivity: times 9.807"});
  where.variant = "1/1000";
  EXPECT_EQ(edits(unit_factor(), where, bundle),
            Edits{"channels[1].sensitivity: times 0.001"});
}

// 100 mV/g is 0.1 V for 9.80665 m/s^2; a volt means as many SI units of what is
// measured in truth.
TEST(SheetEdits, OfAQuantityAreItsUnitAndSensitivityToo) {
  acquisition::TestBundle bundle = support::plate_bundle();
  acquisition::Channel& g = bundle.channels[1];
  g.unit = "g";
  g.unit_to_si = 9.80665;
  g.sensitivity = 0.1;
  g.full_scale_volts = 5.0;
  const Location where{.channels = {"acc1"}, .variant = "integrated"};
  EXPECT_EQ(edits(unit_factor(), where, bundle),
            (Edits{"channels[1].quantity: acceleration -> velocity",
                   "channels[1].unit: g -> m/s",
                   "channels[1].sensitivity: 0.010197 V/(m/s)"}));
  acquisition::TestBundle sheet = bundle;
  unit_factor().correct(where, bundle, sheet);
  EXPECT_NEAR(sheet.channels[1].full_scale_si(), g.full_scale_si(), 1e-12);
  EXPECT_EQ(acquisition::find_unit(sheet.channels[1].unit)->quantity,
            sheet.channels[1].quantity);
}

TEST(SheetEdits, OfASupportAreTheComponentsThatItDoesNotHold) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  Location where{.nodes = {1, 12}};
  const auto released = [&](const std::string& variant) {
    where.variant = variant;
    return edits(support_mismatch(), where, bundle);
  };
  EXPECT_EQ(released("free"),
            Edits{"model: release components 123456 (basic axes) at nodes 1, "
                  "12"});
  EXPECT_EQ(released("free-rotations"),
            Edits{"model: release components 456 (basic axes) at nodes 1, 12"});
  EXPECT_EQ(released("free-Z"),
            Edits{"model: release components 3 (basic axes) at nodes 1, 12"});
  EXPECT_EQ(released("held-translations"),
            Edits{"model: hold components 123 (basic axes) at nodes 1, 12"});
}

TEST(SheetEdits, AreNoneWhereTheSheetHasNoNumberForIt) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  Location where{.channels = {"acc1"}};
  EXPECT_TRUE(edits(channel_gain(), where, bundle).empty());
  where.variant = "10";
  where.runs = {4};
  EXPECT_TRUE(edits(unit_factor(), where, bundle).empty());
}

}  // namespace
}  // namespace tapfit::effects
