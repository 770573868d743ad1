#include "updating/set_up/point_edits.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/mistakes.hpp"
#include "updating/set_up/sheet_edits.hpp"

#include <gtest/gtest.h>

namespace tapfit::effects {
namespace {

using Edits = std::vector<std::string>;

// The plate's test as ready FRFs: its runs and channels are made up.
class PointEdits : public ::testing::Test {
 protected:
  PointEdits() { bundle_.frfs = "plate.uff"; }

  [[nodiscard]] Edits edits(const Effect& effect, const Location& where) const {
    return sheet_edits(effect, where, bundle_, bundle_);
  }
  static Location of(const std::vector<std::string>& channels,
                     const std::string& variant = {}) {
    return {.channels = channels, .variant = variant};
  }
  static Location at(const std::string& channel, int written, int real) {
    return {.node = real, .nodes = {written}, .channels = {channel}};
  }

  acquisition::TestBundle bundle_ = support::plate_bundle();
};

TEST_F(PointEdits, NamePointsOfTheFile) {
  EXPECT_EQ(edits(point_mislabelled(), at("hammer", 28, 30)),
            Edits{"FRFs hit at 28Z+ -> 30Z+"});
  EXPECT_EQ(edits(point_mislabelled(), at("acc2", 36, 33)),
            Edits{"FRFs measured at 36Z- -> 33Z-"});
  EXPECT_EQ(edits(direction_wrong(), of({"acc1"}, "+X")),
            Edits{"FRFs measured at 11Z+ -> 11X+"});
}

TEST_F(PointEdits, NameTheBlowsOfWhichASensorWasElsewhere) {
  Location where = at("acc2", 36, 33);
  where.runs = {4, 5};
  EXPECT_EQ(edits(point_mislabelled(), where),
            Edits{"FRFs measured at 36Z- -> 33Z-, hit at 6Z+, 28Z+"});
}

TEST_F(PointEdits, OfManyPointsAreTheFirstAndTheLast) {
  EXPECT_EQ(edits(direction_wrong(), of({"hammer"}, "+X")),
            Edits{"FRFs hit at 6Z+ -> 6X+ ... 52Z+ -> 52X+ (6 of them)"});
}

// An FRF is the response by the force.
TEST_F(PointEdits, OfAChannelAreWhatItsFrfsAreToBeMultipliedBy) {
  EXPECT_EQ(edits(unit_factor(), of({"acc1"}, "10")),
            Edits{"FRFs of acc1: times 0.1"});
  EXPECT_EQ(edits(unit_factor(), of({"hammer"}, "10")),
            Edits{"FRFs of hammer: times 10"});
  EXPECT_EQ(edits(channel_polarity(), of({"acc1"})),
            Edits{"FRFs of acc1: other sign"});
  EXPECT_EQ(edits(unit_factor(), of({"acc1", "acc2"}, "integrated")),
            Edits{"FRFs of acc1, acc2: velocity, not acceleration"});
}

TEST_F(PointEdits, AreOfRecordsWhereTheFileHoldsThem) {
  bundle_.frfs.reset();
  bundle_.uff = "plate.uff";
  EXPECT_EQ(edits(point_mislabelled(), at("hammer", 28, 30)),
            Edits{"records hit at 28Z+ -> 30Z+"});
  EXPECT_EQ(edits(unit_factor(), of({"hammer"}, "10")),
            Edits{"records of hammer: times 0.1"});
}

}  // namespace
}  // namespace tapfit::effects
