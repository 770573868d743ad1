#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/mistakes.hpp"
#include "updating/set_up/sheet_edits.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::effects {
namespace {

class Directions : public ::testing::Test {
 protected:
  [[nodiscard]] bool tries(const std::vector<std::string>& channels,
                           int grid,
                           const std::string& direction) const {
    Location where{.channels = channels};
    if (grid != 0) where.nodes = {grid};
    where.variant = direction;
    const std::vector<Location> all =
        direction_wrong().places(support::plate_context(bundle_, deck_));
    return std::ranges::find(all, where) != all.end();
  }

  // All three at grid 11, along X, Y and Z.
  void make_triaxial() {
    acquisition::Channel acc3;
    acc3.name = "acc3";
    bundle_.channels.push_back(acc3);
    for (acquisition::Run& run : bundle_.runs) {
      run.sensors = {{1, {11, 1, 1}}, {2, {11, 2, 1}}, {3, {11, 3, 1}}};
    }
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
};

TEST_F(Directions, AreAllOthersOfAChannel) {
  EXPECT_TRUE(tries({"acc1"}, 0, "+X"));
  EXPECT_TRUE(tries({"acc1"}, 0, "-Y"));
  EXPECT_TRUE(tries({"hammer"}, 0, "+X"));
  EXPECT_FALSE(tries({"acc1"}, 0, "+Z")) << "as written";
  EXPECT_FALSE(tries({"acc1"}, 0, "-Z")) << "its polarity";
}

// acc1 along +Z, acc2 along -Z: no two of them are both along +X.
TEST_F(Directions, OfSeveralAreTurnedTogether) {
  const std::vector<std::string> both = {"acc1", "acc2"};
  const std::vector<Location> all =
      direction_wrong().places(support::plate_context(bundle_, deck_));
  EXPECT_EQ(std::ranges::count(all, both, &Location::channels), 4)
      << "Z along X or Y, either way; along -Z is the hammer's polarity";
  EXPECT_FALSE(tries(both, 0, "+X"));
}

TEST_F(Directions, OfATriaxialSensorAreAllItsTurns) {
  make_triaxial();
  const std::vector<std::string> three = {"acc1", "acc2", "acc3"};
  const std::vector<Location> all =
      direction_wrong().places(support::plate_context(bundle_, deck_));
  EXPECT_EQ(std::ranges::count(all, three, &Location::channels), 23)
      << "24 turns bring axes onto axes, one of which is none";
  ASSERT_TRUE(tries(three, 0, "XYZ=+Y-X+Z"));
  const Location quarter{.channels = three, .variant = "XYZ=+Y-X+Z"};
  acquisition::TestBundle sheet = bundle_;
  direction_wrong().correct(quarter, bundle_, sheet);
  const std::vector<acquisition::Placement>& is = sheet.runs[2].sensors;
  EXPECT_EQ(is[0].dof, (Dof{11, 2, 1}));
  EXPECT_EQ(is[1].dof, (Dof{11, 1, -1}));
  EXPECT_EQ(is[2].dof, (Dof{11, 3, 1}));
}

// Each is another direction of the sensor, and right-handed as it was.
TEST_F(Directions, StayAtRightAnglesToEachOther) {
  make_triaxial();
  for (const Location& where :
       direction_wrong().places(support::plate_context(bundle_, deck_))) {
    if (where.channels.size() < 3) continue;
    acquisition::TestBundle sheet = bundle_;
    direction_wrong().correct(where, bundle_, sheet);
    Eigen::Matrix3d axes;
    for (int k = 0; k < 3; ++k) {
      const Dof& dof = sheet.runs[0].sensors[static_cast<std::size_t>(k)].dof;
      axes.col(k) = dof.sign * Eigen::Vector3d::Unit(dof.component - 1);
    }
    EXPECT_EQ(axes.determinant(), 1.0) << where.variant;
  }
}

TEST_F(Directions, TurnRoundAtOnePointOfAChannelThatMoves) {
  EXPECT_TRUE(tries({"hammer"}, 28, "-Z"));
  EXPECT_TRUE(tries({"hammer"}, 28, "+X"));
  EXPECT_FALSE(tries({"hammer"}, 28, "+Z"));
  EXPECT_FALSE(tries({"acc1"}, 11, "+X")) << "its only point: the channel's";
}

TEST_F(Directions, AreCorrectedOnTheSheet) {
  const Location where{.channels = {"acc2"}, .variant = "+X"};
  EXPECT_EQ(sheet_edits(direction_wrong(), where, bundle_, bundle_),
            std::vector<std::string>{"runs[0-5].sensors[1].direction: -Z -> "
                                     "+X"});
}

// There X, Y and Z are axes of the point's own, which the file says as vectors.
TEST_F(Directions, AtAPointOfTheTestsOwnAreSaidAsVectors) {
  acquisition::TestPoint skew;
  skew.label = 3;
  skew.axes << 0.8, 0.0, 0.6, 0.0, 1.0, 0.0, -0.6, 0.0, 0.8;
  bundle_.points = {skew};
  for (acquisition::Run& run : bundle_.runs) run.sensors[1].dof.node = -3;
  const Location where{.channels = {"acc2"}, .variant = "+X"};
  EXPECT_EQ(sheet_edits(direction_wrong(), where, bundle_, bundle_),
            std::vector<std::string>{"runs[0-5].sensors[1].direction: "
                                     "[-0.6, 0, -0.8] -> [0.8, 0, -0.6]"});
  bundle_.points[0].system = 7;
  EXPECT_EQ(sheet_edits(direction_wrong(), where, bundle_, bundle_),
            std::vector<std::string>{"runs[0-5].sensors[1].direction: "
                                     "-Z of system 7 -> +X of system 7"});
}

}  // namespace
}  // namespace tapfit::effects
